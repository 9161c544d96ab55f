#pragma once
#include <string>
#include <vector>

#include "render/frame/frame_camera.h"
#include "render/passes/gbuffer_pass.h"
#include "render/passes/glass_pass.h"
#include "render/scene/scene.h"
#include "tests/benchmark/frame_clock.h"
#include "tests/benchmark/render/benchmarks.h"

namespace rubble::bench {

/// Scene, camera and the passes of primary visibility alone.
class GBufferRig {
public:
    /// Builds the shaders and loads a complete snapshot. Needs a current GL context.
    GBufferRig(const std::string& shaderFolder, FrameSnapshot&& snapshot)
        : shaders(shaderFolder), gbuffer(shaders), glass(shaders) {
        scene.apply(std::move(snapshot));
    }
    /// Camera, targets and uniforms for a view; call it before context().
    void beginFrame(const View& view) {
        scene.beginFrame(1.0f, view.position);
        targets.beginFrame(view.size, view.size, view.cut);
        camera.begin(view, view.size, false, scene.origin(), block);
        glBindBuffer(GL_UNIFORM_BUFFER, m_blockBuffer.get());
        glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, m_blockBuffer.get());
        figures = {};
    }
    /// What passes draw with.
    FrameContext context() { return {block, m_settings, scene, targets, m_noise, figures, m_emptyVertexArray}; }

    ShaderLibrary shaders;
    GBufferPass gbuffer;
    GlassPass glass;
    Scene scene;
    TargetPool targets;
    FrameCamera camera;
    FrameBlock block{};
    RenderStats figures;

private:
    RenderSettings m_settings;
    Texture m_noise;
    GlName<BufferKind> m_blockBuffer = GlName<BufferKind>::make();
    VertexArray m_emptyVertexArray = VertexArray::make();
};

/// Median milliseconds, by frameClockMs(), of draw() and the GL work that it starts. One more call before is not
/// counted.
template <class F>
double medianMs(int frames, F&& draw) {
    std::vector<double> ms;
    for (int i = -1; i < frames; ++i) {
        glFinish();
        const double before = frameClockMs();
        draw();
        glFinish();
        if (i >= 0) ms.push_back(frameClockMs() - before);
    }
    return median(ms);
}

}  // namespace rubble::bench
