#pragma once
#include "render/frame/frame_context.h"
#include "render/shader_library/fullscreen_program.h"

namespace rubble {

/// Finds how much history is left to each pixel of the previous frame where something has changed since then
/// (passes/history_left.frag). [render-thread]
class HistoryLeftPass {
public:
    /// Builds its program. If it fails, shaders.errors() says why and all history is kept.
    explicit HistoryLeftPass(ShaderLibrary& shaders);

    /// Whether there is a history, and something has changed since the previous frame or in the one before.
    static bool needed(const FrameContext& frame);
    void draw(const FrameContext& frame) const;  ///< Only where it is needed.
    /// Sets the uniforms of lib/history_left.glsl. The program must be in use.
    static void bind(const Program& program, const FrameContext& frame);

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
