#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Temporal anti-aliasing, and upsampling from the render size to the display size. Derivation:
/// shaders/passes/taa.frag.
class TaaPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit TaaPass(ShaderLibrary& shaders);
    /// Fills Resolved from Radiance.
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
