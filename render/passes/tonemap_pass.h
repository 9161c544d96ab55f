#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Turns radiance into the displayed image: exposure, bloom, film curve, vignette, dither.
class TonemapPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit TonemapPass(ShaderLibrary& shaders);
    /// Fills Final from Resolved.
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
