#include "render/passes/history_left_pass.h"

#include "render/passes/fullscreen.h"
#include "render/passes/known_changes.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {

HistoryLeftPass::HistoryLeftPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen("passes/history_left.frag")) {}

bool HistoryLeftPass::needed(const FrameContext& frame) {
    const TargetPool& targets = frame.targets;
    const auto hasHistory = [&](Target target) { return bool(targets.previousOrNone(target)); };
    if (!frame.settings.temporal || !frame.settings.rejectStaleHistory || !hasHistory(Target::Surface) ||
        !hasHistory(Target::AccumulatedLight) || !hasHistory(Target::Radiance))
        return false;
    return frame.scene.dirtyRegions().followOthers() || hasKnownChanges(frame, LightGrid::kOldestForAccumulation);
}

void HistoryLeftPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    TargetPool& targets = frame.targets;
    drawFullscreen(frame, m_program, {{&targets.target(Target::HistoryLeft)}}, [&](const Program& program) {
        program.set("uSurfaceHistory", targets.previousOrNone(Target::Surface));
        program.set("uLightHistory", targets.previousOrNone(Target::AccumulatedLight));
        program.set("uRadianceHistory", targets.previousOrNone(Target::Radiance));
        program.set("uDiffuseFractionHistory", targets.previousOrNone(Target::DiffuseFraction));
        setLastConfidence(program, frame);
        setKnownChanges(program, frame, LightGrid::kOldestForAccumulation);
    });
}

void HistoryLeftPass::bind(const Program& program, const FrameContext& frame) {
    const Texture& left = frame.targets.orNone(Target::HistoryLeft);
    program.set("uHistoryLeft", left);
    program.set("uHasHistoryLeft", int(bool(left)));
    program.set("uMaxHistory", float(frame.settings.historyFrames));
}

}  // namespace rubble
