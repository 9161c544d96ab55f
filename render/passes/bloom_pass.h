#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// The glow around what outshines the picture, in "bloom0" (half size): five downscale and back.
class BloomPass {
public:
    explicit BloomPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_down;
    FullscreenProgram& m_up;
};

}  // namespace rubble
