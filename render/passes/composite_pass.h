#pragma once
#include "render/frame_context.h"

namespace rubble {

class GlassShadowPass;

/// Light x albedo, highlights, reflections, glass, emission, air; sky and fields behind: into the history "radiance".
class CompositePass {
public:
    explicit CompositePass(ShaderLibrary& shaders);
    /// glassShadow: null where no sun comes through glass.
    void draw(const FrameContext& frame, const GlassShadowPass* glassShadow) const;

private:
    const Program& m_surfaces;
    const Program& m_background;
};

}  // namespace rubble
