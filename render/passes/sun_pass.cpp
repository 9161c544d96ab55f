#include "render/passes/sun_pass.h"

#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr float kMaxDistance = 200.0f;  ///< metres: shadows of what is farther are not visible

}  // namespace

SunPass::SunPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen("passes/sun.frag", {.surfacesOnly = true, .merge = {Merge::Alpha}})) {}

void SunPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    TargetPool& targets = frame.targets;
    drawFullscreen(frame, m_program, {{&targets.target(Target::NoisyLight)}, &targets.at(Target::DepthBuffer)},
                   [&](const Program& program) {
                       GBufferPass::bind(program, targets);
                       frame.scene.bindShadow(program);
                       frame.scene.bindSmoke(program);
                       program.set("uBlueNoise", frame.blueNoise);
                       program.set("uRayCount", frame.settings.sunRays);
                       program.set("uMaxDistance", kMaxDistance);
                   });
}

}  // namespace rubble
