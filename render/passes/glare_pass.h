#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Adds a glare around each lamp to "radiance". Whether its middle is hidden is asked of the shadow volume, in the
/// vertex shader.
class GlarePass {
public:
    explicit GlarePass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    const Program& m_program;
};

}  // namespace rubble
