#include "render/passes/sky_pass.h"

#include "render/passes/bounce.h"
#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/passes/glass_shadow_pass.h"
#include "render/scene/scene.h"

namespace rubble {

SkyPass::SkyPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen("passes/sky.frag", {.surfacesOnly = true, .merge = {Merge::Color}})) {}

void SkyPass::draw(const FrameContext& frame, const GlassShadowPass* glassShadow) const {
    if (!m_program) return;
    TargetPool& targets = frame.targets;
    const FullscreenTargets into{{&targets.target(Target::NoisyLight), &targets.target(Target::HitProximity)},
                                 &targets.at(Target::DepthBuffer)};
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        GBufferPass::bind(program, targets);
        frame.scene.bindShadow(program);
        GlassShadowPass::bind(program, glassShadow);
        bindBounce(program, frame, BounceRays::Diffuse);
        program.set("uBlueNoise", frame.blueNoise);
        program.set("uLightHistory", targets.history(Target::AccumulatedLight).previous);
        program.set("uRayCount", frame.settings.skyRays);
        program.set("uExactDistance", frame.settings.skyExactDistance);
    });
}

}  // namespace rubble
