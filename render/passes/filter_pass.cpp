#include "render/passes/filter_pass.h"

#include <algorithm>

#include "render/passes/fullscreen.h"

namespace rubble {

FilterPass::FilterPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen("passes/filter.frag", {.limited = true})) {}

void FilterPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const Texture* source = &frame.targets.at("accumulatedLight");
    const int steps = std::max(frame.settings.filterPasses, 1);
    for (int step = 0; step < steps; ++step) {
        // The last step ends in "denoisedLight", whatever their number.
        const Texture& target =
            frame.targets.target((steps - step) % 2 ? "denoisedLight" : "denoisedLightScratch", GL_RGBA16F);
        const FullscreenTargets into{frame.targets, {&target}, &frame.targets.at("depthBuffer"), {glm::vec4(0.0f)}};
        drawFullscreen(frame, m_program, into, [&](const Program& program) {
            program.set("uSurface", frame.targets.at("surface"));
            program.set("uSunRays", float(frame.settings.sunRays));
            program.set("uLight", *source);
            // Without filter passes the one step looks at the pixel alone.
            program.set("uStride", frame.settings.filterPasses ? 1 << step : 0);
            program.set("uDiagonal", step % 2);
        });
        source = &target;
    }
}

}  // namespace rubble
