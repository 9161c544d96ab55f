#include "render/passes/sky_pass.h"

#include "render/passes/bounce.h"
#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {

SkyPass::SkyPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen("passes/sky.frag", {.limited = true, .merge = {Merge::Color}})) {}

void SkyPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    TargetPool& targets = frame.targets;
    const FullscreenTargets into{targets,
                                 {&targets.target("noisyLight", GL_RGBA16F), &targets.target("hitProximity", GL_R8)},
                                 &targets.at("depthBuffer")};
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        GBufferPass::bind(program, targets);
        frame.scene.bindShadow(program);
        bindBounce(program, frame, BounceRays::Gathered);
        program.set("uBlueNoise", frame.blueNoise);
        program.set("uLightHistory", targets.history("accumulatedLight", GL_RGBA16F).previous);
        program.set("uRayCount", frame.settings.skyRays);
        program.set("uExactDistance", frame.settings.skyExactDistance);
    });
}

}  // namespace rubble
