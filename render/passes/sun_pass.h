#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Sunlight: rays to random points of the sun's disc, so that shadows have penumbras.
class SunPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit SunPass(ShaderLibrary& shaders);
    /// Fills the alpha of NoisyLight: the share of the disc that a pixel sees.
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
