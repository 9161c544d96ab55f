#pragma once
#include "render/frame_context.h"

namespace rubble {

/// Albedo by the angle to the sun, without a ray: what is drawn until lighting is there. Writes "final".
class SimpleLightPass {
public:
    explicit SimpleLightPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame);

private:
    const Program& m_program;
};

}  // namespace rubble
