#include "render/passes/relight_pass.h"

#include "render/frame/shader_constants.h"
#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr float kMinRadiance = 0.001f;  ///< of a white surface at exposure 1: fainter differences get no ray

static_assert(kTargets[size_t(Target::LightOffset)].divisor == shared::kConfidenceTile);

void bindChangedLight(const Program& program, const FrameContext& frame) {
    const Texture& changed = frame.targets.orNone(Target::ChangedLight);
    program.set("uChangedLight", changed);
    program.set("uHasChangedLight", int(bool(changed)));
}

bool hasDifferences(const FrameContext& frame) {
    return frame.settings.localLights && frame.lightGrid && !frame.lightGrid->differences().empty();
}

}  // namespace

RelightPass::RelightPass(ShaderLibrary& shaders)
    : m_differences(shaders.loadFullscreen("passes/changed_lights.frag", {.surfacesOnly = true})),
      m_offset(shaders.loadFullscreen("passes/light_offset.frag")),
      m_offsetFilter(shaders.loadFullscreen("passes/light_offset_filter.frag")) {}

bool RelightPass::needed(const FrameContext& frame) {
    return frame.settings.temporal && frame.settings.rejectStaleHistory &&
           frame.targets.previousOrNone(Target::AccumulatedLight) && frame.targets.previousOrNone(Target::Surface) &&
           (frame.targets.orNone(Target::HistoryLeft) || hasDifferences(frame));
}

void RelightPass::draw(const FrameContext& frame) const {
    if (!m_differences || !m_offset || !m_offsetFilter) return;
    if (hasDifferences(frame)) sampleDifferences(frame);
    if (frame.targets.orNone(Target::HistoryLeft)) findOffset(frame);
}

void RelightPass::sampleDifferences(const FrameContext& frame) const {
    const FullscreenTargets into{.colors = {&frame.targets.target(Target::ChangedLight)},
                                 .depth = &frame.targets.at(Target::DepthBuffer),
                                 .clear = {glm::vec4(0.0f)}};
    drawFullscreen(frame, m_differences, into, [&](const Program& program) {
        GBufferPass::bind(program, frame.targets);
        frame.scene.bindShadow(program);
        LightGrid::bind(program, frame.lightGrid);
        program.set("uBlueNoise", frame.blueNoise);
        program.set("uFirstDifference", frame.lightGrid->firstDifference());
        program.set("uDifferenceCount", int(frame.lightGrid->differences().size()));
        program.set("uMinRadiance", kMinRadiance / frame.block.exposure.x);
    });
}

void RelightPass::findOffset(const FrameContext& frame) const {
    const Texture& noisy = frame.targets.target(Target::NoisyLightOffset);
    drawFullscreen(frame, m_offset, {{&noisy}}, [&](const Program& program) {
        GBufferPass::bind(program, frame.targets);
        program.set("uLight", frame.targets.at(Target::NoisyLight));
        program.set("uLightHistory", frame.targets.previousOrNone(Target::AccumulatedLight));
        program.set("uSurfaceHistory", frame.targets.previousOrNone(Target::Surface));
        bindChangedLight(program, frame);
    });
    drawFullscreen(frame, m_offsetFilter, {{&frame.targets.target(Target::LightOffset)}}, [&](const Program& program) {
        GBufferPass::bind(program, frame.targets);
        program.set("uOffset", noisy);
    });
}

void RelightPass::bind(const Program& program, const FrameContext& frame) {
    bindChangedLight(program, frame);
    const Texture& offset = frame.targets.orNone(Target::LightOffset);
    program.set("uLightOffset", offset);
    program.set("uHasLightOffset", int(bool(offset)));
}

}  // namespace rubble
