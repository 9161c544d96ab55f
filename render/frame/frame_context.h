#pragma once
#include "render/frame/frame_block.h"
#include "render/frame/render_settings.h"
#include "render/frame/render_stats.h"
#include "render/frame/target_pool.h"
#include "render/shader_library/shader_library.h"

namespace rubble {

class Scene;
class LightGrid;
class FullscreenChoice;

/// What passes are given while they draw one frame.
struct FrameContext {
    const FrameBlock& block;  ///< already bound for shaders
    const RenderSettings& settings;
    const Scene& scene;  ///< the GPU's copy of the world: bodies, lights, environment, shadow volume
    TargetPool& targets;
    const Texture& blueNoise;  ///< makeNoiseTexture()
    RenderStats& stats;
    VertexArray& emptyVertexArray;
    const LightGrid* lightGrid = nullptr;  ///< null: the scene has had no local lights yet
    FullscreenChoice* choice = nullptr;    ///< how full-screen programs are drawn; null: by fragments
    float seconds = 1.0f / 60.0f;          ///< since the frame before
    TargetPool* mainTargets = nullptr;  ///< what the frame before left, where `targets` are others; null: they are not

    /// The same for other pixels and targets.
    FrameContext with(const FrameBlock& otherBlock, TargetPool& others) const {
        return {otherBlock,       settings,  scene,  others,  blueNoise, stats,
                emptyVertexArray, lightGrid, choice, seconds, &targets};
    }
    /// The targets of which rays look up what the frame before showed.
    TargetPool& pastTargets() const { return mainTargets ? *mainTargets : targets; }

    /// Draws one triangle over the bound framebuffer with the program in use and the GL state as it is. For programs of
    /// ShaderLibrary::load(); those of loadFullscreen() are drawn by render/passes/fullscreen.h.
    void drawTriangle() const {
        glBindVertexArray(emptyVertexArray.get());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        ++stats.drawCalls;
    }
};

}  // namespace rubble
