#include "render/passes/wetness_pass.h"

#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr float kRoofDistance = 60.0f;  ///< metres up to which something overhead keeps a surface dry

}  // namespace

WetnessPass::WetnessPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen("passes/wetness.frag", {.surfacesOnly = true}, "nothing gets wet")) {}

void WetnessPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    TargetPool& targets = frame.targets;
    // It cannot read the targets that it writes, so it reads copies.
    const Texture &albedo = targets.at(Target::Albedo), &material = targets.at(Target::Material);
    const Texture &dryAlbedo = targets.copy(Target::Albedo, Target::DryAlbedo),
                  &dryMaterial = targets.copy(Target::Material, Target::DryMaterial);
    const FullscreenTargets into{{&albedo, &material}, &targets.at(Target::DepthBuffer)};
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
