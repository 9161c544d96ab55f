#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "render/frame/target_pool.h"
#include "render/renderer.h"
#include "render/shader_library/shader_library.h"

namespace rubble {

class Scene;
class LightGrid;
class FullscreenChoice;

/// The uniforms that every pass sees (lib/frame.glsl).
struct FrameBlock {
    using vec4 = glm::vec4;
    using ivec4 = glm::ivec4;
    using mat4 = glm::mat4;
#include "shaders/shared/frame_block.h"
};

/// What a pass has at hand while it draws one frame.
struct FrameContext {
    const FrameBlock& block;  ///< bound for shaders already
    const RenderSettings& settings;
    const Scene& scene;        ///< the world's mirror on the GPU: bodies, lights, environment, shadow volume
    TargetPool& targets;       ///< what is traced, lit and filtered
    TargetPool& pictures;      ///< from "resolved" on: in the size that is shown
    const Texture& blueNoise;  ///< 64x64, R8, repeats
    RenderFigures& figures;
    VertexArray& emptyVertexArray;
    const LightGrid* lightGrid = nullptr;  ///< null: the scene has had no local lights yet
    FullscreenChoice* choice = nullptr;    ///< of what draws full-screen programs; null: fragments

    /// Draws one triangle over the framebuffer that is bound, with the plain program that is in use; for those that
    /// compute may draw too see render/passes/fullscreen.h. State: no depth test, no blending.
    void drawFullscreen() const {
        glBindVertexArray(emptyVertexArray.get());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        ++figures.drawCalls;
    }
};

}  // namespace rubble
