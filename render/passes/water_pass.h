#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Draws the surfaces of waters over "radiance": what is below is bent by the waves and tinted by the way through the
/// water, what is around is mirrored by rays, foam lies where the water ends. Seen from above only; of an outline the
/// first 32 corners count.
class WaterPass {
public:
    explicit WaterPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
