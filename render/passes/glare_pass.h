#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Glare: a glow on the lens around each local light that the camera sees. The vertex shader finds by four rays through
/// the shadow volume how much of the light is visible.
class GlarePass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit GlarePass(ShaderLibrary& shaders);
    /// Adds to Radiance.
    void draw(const FrameContext& frame) const;

private:
    const Program& m_program;
};

}  // namespace rubble
