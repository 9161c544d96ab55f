#include "render/passes/wetness_pass.h"

#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr float kRoofDistance = 60.0f;  // metres

}  // namespace

WetnessPass::WetnessPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen("passes/wetness.frag", {.limited = true})) {
    if (!m_program) logError("nothing gets wet: " + shaders.errors().back());
}

void WetnessPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    TargetPool& targets = frame.targets;
    // What it writes it does not read: that comes from copies.
    const Texture &albedo = targets.at("albedo"), &material = targets.at("material");
    const Texture &dryAlbedo = targets.copy(albedo, "dryAlbedo"), &dryMaterial = targets.copy(material, "dryMaterial");
    const FullscreenTargets into{targets, {&albedo, &material}, &targets.at("depthBuffer")};
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        GBufferPass::bind(program, targets);
        program.set("uAlbedo", dryAlbedo);
        program.set("uMaterial", dryMaterial);
        frame.scene.bindShadow(program);
        program.set("uBlueNoise", frame.blueNoise);
        program.set("uMaxDistance", kRoofDistance);
    });
}

}  // namespace rubble
