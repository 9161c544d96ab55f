#pragma once
#include "render/frame_context.h"

namespace rubble {

/// Light x albedo, highlights, reflections, glass, emission, air; sky and fields behind: into the history "radiance".
class CompositePass {
public:
    explicit CompositePass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    const Program& m_surfaces;
    const Program& m_background;
};

}  // namespace rubble
