#include "render/passes/filter_pass.h"

#include <algorithm>

#include "render/passes/fullscreen.h"
#include "render/scene/scene.h"

namespace rubble {

FilterPass::FilterPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen("passes/filter.frag", {.surfacesOnly = true})) {}

void FilterPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const Texture* source = &frame.targets.at(Target::AccumulatedLight);
    const int steps = std::max(frame.settings.filterPasses, 1);
    for (int step = 0; step < steps; ++step) {
        // The two targets alternate; the last step writes DenoisedLight.
        const Texture& target =
            frame.targets.target((steps - step) % 2 ? Target::DenoisedLight : Target::DenoisedLightScratch);
        FullscreenTargets into{{&target}, &frame.targets.at(Target::DepthBuffer)};
        if (step < 2) into.clear = {glm::vec4(0.0f)};  // later steps draw the same pixels
        drawFullscreen(frame, m_program, into, [&](const Program& program) {
            program.set("uSurface", frame.targets.at(Target::Surface));
            program.set("uSunRays", float(frame.settings.sunRays));
            program.set("uSunFrames", 1.0f / std::max(frame.scene.lookChanges().newSunShare(), 1e-3f));
            program.set("uLight", *source);
            // Without filter passes one step of stride 0 copies each pixel.
            program.set("uStride", frame.settings.filterPasses ? 1 << step : 0);
            program.set("uDiagonal", step % 2);
        });
        source = &target;
    }
}

}  // namespace rubble
