#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Bloom: the part of the image that outshines white, blurred by downsampling to five levels and back up.
class BloomPass {
public:
    /// Builds its programs. If one fails, shaders.errors() says why and it is not drawn.
    explicit BloomPass(ShaderLibrary& shaders);
    /// Fills Bloom0 (half size) to Bloom4 from Resolved.
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_down;
    FullscreenProgram& m_up;
};

}  // namespace rubble
