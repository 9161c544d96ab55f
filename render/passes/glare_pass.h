#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Glare: a glow on the lens around each local light that the camera sees. The vertex shader asks the shadow volume
/// whether the light's centre is hidden.
class GlarePass {
public:
    /// Builds its program.
    explicit GlarePass(ShaderLibrary& shaders);
    /// Adds to Radiance.
    void draw(const FrameContext& frame) const;

private:
    const Program& m_program;
};

}  // namespace rubble
