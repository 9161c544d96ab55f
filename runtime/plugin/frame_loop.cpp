#include "runtime/plugin/frame_loop.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/world/impacts/break_through.h"
#include "runtime/world/impacts/impact_damage.h"

namespace rubble {

FrameLoop::FrameLoop(const FrameLoopSettings& settings)
    : m_world(settings.worldId, settings.firstGeneration),
      m_threads(settings.physicsThreads > 1 ? std::make_unique<ThreadPool>(settings.physicsThreads) : nullptr),
      m_physics(withThreads(settings.physics)),
      m_snapshots(settings.particles),
      m_publish(settings.publish),
      m_moveParticles(settings.moveParticles),
      m_waitForShadow(settings.waitForShadow) {
    if (settings.shadowVolume) m_shadow = std::make_unique<ShadowWorker>(settings.shadow);
    if (settings.copyShadow) m_shadowCopy = std::make_unique<ShadowCopy>();
}

FrameLoop::~FrameLoop() {
    endRecording();
}

ParallelFor FrameLoop::parallelFor() const {
    if (!m_threads) return serialFor;
    return [threads = m_threads.get()](size_t count, const std::function<void(size_t)>& body) {
        threads->run(count, body);
    };
}

PhysicsSettings FrameLoop::withThreads(PhysicsSettings settings) const {
    if (m_threads) settings.parallelFor = parallelFor();
    return settings;
}

void FrameLoop::dropWaitingEdits() {
    if (const size_t count = m_edits.take().size())
        logWarning(std::to_string(count) + " edits that waited for the next step are dropped: the world is replaced");
}

void FrameLoop::load(const Level& level) {
    dropWaitingEdits();
    m_changes = {};
    m_pending.clear();
    endRecording();
    m_world.load(level);
}

void FrameLoop::load(SavedGame game) {
    dropWaitingEdits();
    m_changes = {};
    endRecording();
    m_world.setState(std::move(game.world));
    m_pending = std::move(game.pending);
    claimHandles(m_world, m_pending);  // before a host reserves more
}

/// The game as it is now, with `waiting` behind the edits that it has made itself.
SavedGame FrameLoop::savedGame(const Edits& waiting) const {
    SavedGame game{m_world.state(), m_pending};
    restartPendingSplits(game.world);
    game.pending.insert(game.pending.end(), waiting.begin(), waiting.end());
    return game;
}

SavedGame FrameLoop::save() {
    SavedGame game = savedGame(m_edits.waiting());
    goOnAsLoaded(false);
    return game;
}

Result<Done> FrameLoop::save(const std::string& path) {
    Result<Done> written = writeSave(path, savedGame(m_edits.waiting()));
    if (written) goOnAsLoaded(false);
    return written;
}

void FrameLoop::goOnAsLoaded(bool dropMarks) {
    m_rebuildPhysics = true;
    m_world.resetCaches(dropMarks);
}

/// The queue of edits is not in the saved game that it begins with, because the first step records it.
Result<Done> FrameLoop::startRecording(const std::string& path) {
    Result<RecordingWriter> writer = RecordingWriter::open(path, savedGame({}));
    if (!writer) return Error{writer.error()};
    endRecording();
    goOnAsLoaded(true);
    m_recorder = std::make_unique<Recorder>(std::move(*writer), m_world);
    return Done{};
}

Result<Done> FrameLoop::stopRecording() {
    if (!m_recorder) return Done{};
    const std::unique_ptr<Recorder> recorder = std::move(m_recorder);
    return recorder->close();
}

/// Stops a recording that nobody waits for.
void FrameLoop::endRecording() {
    if (const Result<Done> stopped = stopRecording(); !stopped) logError(stopped.error());
}

void FrameLoop::step() {
    Edits edits = m_edits.take();
    stepWith(edits);
    m_edits.recycle(std::move(edits));
}

void FrameLoop::replay(const RecordedStep& step) {
    m_rebuildPhysics = step.physicsRebuilt;
    if (m_rebuildPhysics) m_world.resetCaches();
    stepWith(step.edits);
}

void FrameLoop::stepWith(const Edits& hostEdits) {
    std::fill_n(m_times.ms.begin(), size_t(Stage::Apply), 0.0);  // the stages from Apply on are the render thread's
    loadPhysics();
    applyEdits(hostEdits);
    stepPhysics();
    collectDamage();
    if (!m_mustPublishAll.exchange(false)) return publish(m_changes);
    FrameChanges all = m_changes;
    all.levelReplaced = true;
    publish(all);
}

/// Before the edits, so that physics can tell what they change.
void FrameLoop::loadPhysics() {
    if (!m_rebuildPhysics && !m_world.data().levelReplaced) return;
    const ScopedTimer timer(m_times[Stage::Physics]);
    m_physics.load(m_world);
}

void FrameLoop::applyEdits(const Edits& hostEdits) {
    const ScopedTimer timer(m_times[Stage::ApplyEdits]);
    m_changes = m_world.applyEdits(hostEdits, std::exchange(m_pending, {}));
    if (m_recorder) m_recorder->recordEdits(hostEdits, m_changes, m_world, m_rebuildPhysics);
    m_rebuildPhysics = false;
}

void FrameLoop::stepPhysics() {
    {
        const ScopedTimer timer(m_times[Stage::Physics]);
        m_physics.apply(m_changes, m_world);
        m_physics.step();
    }
    const ScopedTimer timer(m_times[Stage::Poses]);
    copyMotion(m_physics, m_world);
    if (m_recorder) m_recorder->recordMotion(m_physics.poses(), m_physics.characters(), m_world);
}

/// What impacts and forces break is carried out in the next step: no stage runs twice in one.
void FrameLoop::collectDamage() {
    const ScopedTimer timer(m_times[Stage::Impacts]);
    m_pending = impactDamage(m_world, m_physics.impacts());
    addBreakThroughImpulses(m_world, m_physics.impacts(), m_pending);
    for (const JointHandle joint : m_physics.jointBreaks())
        m_pending.emplace_back(RemoveJointEdit{joint, JointBreak::Force});
}

std::span<const BodyPose> FrameLoop::changedPoses() {
    const std::span<const BodyPose> poses = m_physics.poses();
    if (m_changes.teleported.empty()) return poses;
    m_changedPoses.assign(poses.begin(), poses.end());
    for (const BodyHandle handle : m_changes.teleported)
        if (const Body* body = m_world.bodies().find(handle))
            m_changedPoses.push_back({handle, body->pose, body->velocity, body->angularVelocity, body->asleep});
    return m_changedPoses;
}

void FrameLoop::publish(const FrameChanges& changes) {
    if (m_shadow) {
        const ScopedTimer timer(m_times[Stage::Shadow]);
        m_shadow->submit(changes, changedPoses(), m_world);
    }
    const ScopedTimer timer(m_times[Stage::Publish]);
    if (!m_publish && m_moveParticles) m_snapshots.stepParticles(changes, m_physics.impacts(), m_world);
    if (!m_shadow) {
        if (m_publish) m_snapshots.publishWithoutShadow(changes, changedPoses(), m_world, m_physics.impacts());
        return;
    }
    m_shadowLag = changes.step - m_shadow->publishedVersion();
    if (m_waitForShadow) m_shadow->waitFor(changes.step);
    std::vector<ShadowPatches> patches = m_shadow->takePatches();
    if (m_shadowCopy) m_shadowCopy->follow(patches);
    if (m_publish) m_snapshots.publish(changes, changedPoses(), m_world, std::move(patches), m_physics.impacts());
}

void FrameLoop::restartDrawing() {
    m_awaitsAll = true;
    m_mustPublishAll = true;
}

void FrameLoop::draw(Renderer& renderer, const View& view, float alpha) {
    {
        m_times[Stage::Apply] = 0.0;
        const ScopedTimer timer(m_times[Stage::Apply]);
        std::optional<FrameSnapshot> snapshot = m_snapshots.take();
        if (snapshot && snapshot->replacesAll) m_awaitsAll = false;
        if (snapshot && !m_awaitsAll) renderer.apply(std::move(*snapshot));
    }
    m_times[Stage::Draw] = 0.0;
    const ScopedTimer timer(m_times[Stage::Draw]);
    renderer.draw(view, alpha);
}

}  // namespace rubble
