// How a world keeps what its steps change, and how another one follows it.
#include <fmt/format.h>

#include "runtime/plugin/frame_loop.h"

namespace rubble {

void FrameLoop::keepDeltas(std::optional<DeltaContent> content, bool withEvents) {
    std::unique_ptr<DeltaWriter> deltas;  // what throws leaves those that are kept
    std::unique_ptr<Recorder> recorder;
    if (content) {
        deltas = std::make_unique<DeltaWriter>(m_world.step(), *content, withEvents);
        recorder = std::make_unique<Recorder>(m_world, *content,
                                              [to = deltas.get()](const RecordedStep& step) { to->add(step); });
    }
    m_deltaRecorder = std::move(recorder);
    m_deltas = std::move(deltas);
}

Result<Done> FrameLoop::follow(const Deltas& deltas, const std::function<void()>& afterStep) {
    const DeltaSpan& span = deltas.span;
    const auto endOwn = [&] {  // a recording would miss these steps, as would deltas of this world
        endRecording();
        keepDeltas(std::nullopt);
    };
    if (span.from == span.to) {
        endOwn();
        return Done{};
    }
    if (span.from != m_world.step() || (span.from != span.start && span.start != m_followedStart))
        return Error{fmt::format(
            "expected the delta of step {}, the next of those that were applied, found that of step {}, kept "
            "since step {}: a follower begins with the game that is saved after keep_deltas()",
            m_world.step() + 1, span.from + 1, span.start)};
    std::vector<PaletteRef> replaced;  // by those of another keep_deltas()
    if (span.from == span.start) replaced.swap(m_followedPalettes);
    auto next = deltas.steps.begin();
    auto nextEvents = deltas.events.begin();
    for (uint64_t step = span.from + 1; step <= span.to; ++step) {
        const bool isIn = next != deltas.steps.end() && next->step == step;
        const bool hasEvents = nextEvents != deltas.events.end() && nextEvents->step == step;
        const StepEvents* events = hasEvents ? &*nextEvents++ : nullptr;
        Result<Done> done = isIn ? followStep(*next, span.content, events) : followEmptyStep(events);
        if (m_world.step() == span.from) {  // the first step was refused: this call has had no effect
            if (span.from == span.start) m_followedPalettes = std::move(replaced);
            return done;
        }
        endOwn();
        m_followedStart = span.start;
        if (!done) return done;
        if (isIn) ++next;
        afterStep();
    }
    return Done{};
}

Result<Done> FrameLoop::followStep(const RecordedStep& step, DeltaContent content, const StepEvents* events) {
    const size_t known = m_followedPalettes.size();
    Result<FrameChanges> applied =
        applyStepDelta(step.delta, fmt::format("step {}", step.step), m_world, m_followedPalettes);
    if (!applied) {
        m_followedPalettes.resize(known);
        return Error{applied.error()};
    }
    m_changes = std::move(*applied);
    if (events) addEvents(*events, m_changes);
    m_rebuildPhysics = true;
    if (content == DeltaContent::All) {
        m_world.setPoses(step.poses, step.hostMotion ? step.step - 1 : step.step);  // a host moves them before its step
        m_world.setCharacters(step.characters);
        m_movedByHost.assign(step.poses.begin(), step.poses.end());
    } else {
        readHostMotion();
    }
    forgetHostMotion();
    publish(m_changes, changedPoses(m_movedByHost), {});
    const bool isEqual = content == DeltaContent::All ? resolvedHash(m_world) == step.resolvedHash
                                                      : voxelHash(m_world) == step.voxelHash;
    if (isEqual) return Done{};
    return Error{
        fmt::format("step {}: expected the state of the world that made the delta, found another: the two were "
                    "not equal before",
                    step.step)};
}

/// A step in which edits changed nothing.
Result<Done> FrameLoop::followEmptyStep(const StepEvents* events) {
    m_changes = m_world.applyDelta(std::nullopt);
    if (events) addEvents(*events, m_changes);
    m_rebuildPhysics = true;
    readHostMotion();
    forgetHostMotion();
    publish(m_changes, changedPoses(m_movedByHost), {});
    return Done{};
}

}  // namespace rubble
