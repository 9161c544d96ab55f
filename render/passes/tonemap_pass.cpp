#include "render/passes/tonemap_pass.h"

#include "render/passes/fullscreen.h"

namespace rubble {

TonemapPass::TonemapPass(ShaderLibrary& shaders) : m_program(shaders.loadFullscreen("passes/tonemap.frag")) {}

void TonemapPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    drawFullscreen(frame, m_program, {{&frame.targets.target(Target::Final)}}, [&](const Program& program) {
        program.set("uColor", frame.targets.at(Target::Resolved));
        program.set("uExposure", frame.targets.at(Target::Exposure));
        program.set("uBlueNoise", frame.blueNoise);
        program.set("uBloomShare", frame.settings.bloom);
        if (frame.settings.bloom > 0.0f) program.set("uBloom", frame.targets.at(Target::Bloom0));
        // TAA blurs a little; without it the image is as sharp as it gets.
        program.set("uSharpen", frame.settings.temporal ? 0.35f : 0.0f);
    });
}

}  // namespace rubble
