#include "render/passes/accumulate_pass.h"

#include "render/frame/shader_constants.h"
#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/passes/history_left_pass.h"
#include "render/passes/known_changes.h"
#include "render/passes/relight_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

static_assert(kTargets[size_t(Target::HistoryConfidence)].divisor == shared::kConfidenceTile);
static_assert(kTargets[size_t(Target::FastHistory)].divisor == shared::kConfidenceTile);

}  // namespace

AccumulatePass::AccumulatePass(ShaderLibrary& shaders)
    : m_change(shaders.loadFullscreen("passes/light_change.frag")),
      m_program(shaders.loadFullscreen("passes/accumulate.frag", {.surfacesOnly = true})) {}

void AccumulatePass::findChanges(const FrameContext& frame, const History& light, const History& surface) const {
    const History fast = frame.targets.history(Target::FastHistory);
    const Texture& confidence = frame.targets.history(Target::HistoryConfidence).current;
    drawFullscreen(frame, m_change, {{&fast.current, &confidence}}, [&](const Program& program) {
        program.set("uLight", frame.targets.at(Target::NoisyLight));
        program.set("uMotion", frame.targets.at(Target::Motion));
        program.set("uLightHistory", light.previous);
        program.set("uSurfaceHistory", surface.previous);
        program.set("uFastHistory", fast.previous);
        program.set("uHistoryValid", int(light.valid && surface.valid && fast.valid));
        program.set("uDepth", frame.targets.at(Target::Depth));
        program.set("uHasGlass", int(frame.scene.hasGlass()));
        setKnownChanges(program, frame, LightGrid::kOldestForAccumulation);
        RelightPass::bind(program, frame);
    });
}

void AccumulatePass::draw(const FrameContext& frame) const {
    if (!m_change || !m_program) return;
    const History light = frame.targets.history(Target::AccumulatedLight);
    const History surface = frame.targets.history(Target::Surface);
    const bool hasHistory = frame.settings.temporal && light.valid && surface.valid;
    const bool hasConfidence = hasHistory && frame.settings.rejectStaleHistory;
    if (hasConfidence) findChanges(frame, light, surface);
    const glm::vec4 none(0.0f), sky(shared::kSkyDepth, -1, 0, 0);
    const FullscreenTargets into{
        {&light.current, &surface.current}, &frame.targets.at(Target::DepthBuffer), {none, sky}};
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        GBufferPass::bind(program, frame.targets);
        program.set("uLight", frame.targets.at(Target::NoisyLight));
        program.set("uHasHitProximity", int(frame.settings.sky));
        program.set("uHitProximity", frame.targets.orNone(Target::HitProximity));
        program.set("uLightHistory", light.previous);
        program.set("uSurfaceHistory", surface.previous);
        program.set("uHistoryConfidence", frame.targets.orNone(Target::HistoryConfidence));
        program.set("uHasConfidence", int(hasConfidence));
        program.set("uHistoryValid", int(hasHistory));
        program.set("uNewSunShare", frame.settings.rejectStaleHistory ? frame.scene.lookChanges().newSunShare() : 0.0f);
        HistoryLeftPass::bind(program, frame);
        RelightPass::bind(program, frame);
    });
}

}  // namespace rubble
