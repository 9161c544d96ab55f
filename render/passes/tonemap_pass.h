#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Turns "resolved" into "final": exposure, bloom, film curve, vignette, dither.
class TonemapPass {
public:
    explicit TonemapPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
