#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Writes the colour of "noisyLight": mean radiance from the sky and from what hides it; and "hitProximity", how near
/// that is.
class SkyPass {
public:
    explicit SkyPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
