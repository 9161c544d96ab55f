#pragma once
#include "render/frame_context.h"

namespace rubble {

/// Draws all bodies into albedo, normal, material, motion and depth; lib/gbuffer.glsl says what they hold.
class GBufferPass {
public:
    explicit GBufferPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame);
    /// Binds the G-buffer's targets to the samplers of lib/gbuffer.glsl, for a later pass whose program is in use.
    static void bind(const Program& program, const TargetPool& targets);
};

}  // namespace rubble
