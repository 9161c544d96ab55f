// How a world keeps what its steps change, and how another one follows it.
#include <fmt/format.h>

#include "runtime/plugin/frame_loop.h"

namespace rubble {

void FrameLoop::keepDeltas(bool on) {
    m_deltaRecorder.reset();
    m_deltas.reset();
    if (!on) return;
    m_deltas = std::make_unique<DeltaWriter>(m_world.step());
    m_deltaRecorder =
        std::make_unique<Recorder>(m_world, [to = m_deltas.get()](const RecordedStep& step) { to->add(step); });
}

Result<Done> FrameLoop::follow(const Deltas& deltas, const std::function<void()>& afterStep) {
    endRecording();  // it would miss these steps, as would deltas of this world
    keepDeltas(false);
    for (const RecordedStep& step : deltas.steps) {
        const bool isFirst = step.step == deltas.start + 1;
        if (step.step != m_world.step() + 1 || (!isFirst && deltas.start != m_followedStart))
            return Error{
                fmt::format("expected the delta of step {}, the next of those that were applied, found that of "
                            "step {}, kept since step {}",
                            m_world.step() + 1, step.step, deltas.start)};
        if (isFirst) m_followedPalettes.clear();
        m_followedStart = deltas.start;
        if (Result<Done> done = followStep(step); !done) return done;
        afterStep();
    }
    return Done{};
}

Result<Done> FrameLoop::followStep(const RecordedStep& step) {
    const size_t known = m_followedPalettes.size();
    Result<FrameChanges> applied =
        applyStepDelta(step.delta, fmt::format("step {}", step.step), m_world, m_followedPalettes);
    if (!applied) {
        m_followedPalettes.resize(known);
        return Error{applied.error()};
    }
    m_changes = std::move(*applied);
    m_rebuildPhysics = true;
    m_world.setPoses(step.poses);
    m_world.setCharacters(step.characters);
    m_movedByHost.assign(step.poses.begin(), step.poses.end());
    publish(m_changes, m_movedByHost, {});
    if (resolvedHash(m_world) == step.resolvedHash) return Done{};
    return Error{
        fmt::format("step {}: expected the state of the world that made the delta, found another: the two were "
                    "not equal before",
                    step.step)};
}

}  // namespace rubble
