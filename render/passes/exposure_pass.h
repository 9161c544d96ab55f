#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Adapts the exposure to the brightness of the image over time. Derivation: shaders/passes/exposure.frag.
class ExposurePass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit ExposurePass(ShaderLibrary& shaders);
    /// Fills the one texel of Exposure from Resolved. isFixed: with 1.
    void draw(const FrameContext& frame, bool isFixed) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
