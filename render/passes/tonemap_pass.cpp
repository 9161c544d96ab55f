#include "render/passes/tonemap_pass.h"

#include "render/passes/fullscreen.h"

namespace rubble {
namespace {

constexpr float kTaaSharpening = 0.35f;  ///< share of the contrast to the neighbours that is added: TAA blurs a little

}  // namespace

TonemapPass::TonemapPass(ShaderLibrary& shaders) : m_program(shaders.loadFullscreen("passes/tonemap.frag")) {}

void TonemapPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    drawFullscreen(frame, m_program, {{&frame.targets.target(Target::Final)}}, [&](const Program& program) {
        program.set("uColor", frame.targets.at(Target::Resolved));
        program.set("uExposure", frame.targets.at(Target::Exposure));
        program.set("uBlueNoise", frame.blueNoise);
        program.set("uBloomShare", frame.settings.bloom);
        program.set("uBloom", frame.targets.orNone(Target::Bloom0));
        program.set("uSharpen", frame.settings.temporal ? kTaaSharpening : 0.0f);
    });
}

}  // namespace rubble
