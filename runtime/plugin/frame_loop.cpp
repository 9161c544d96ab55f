#include "runtime/plugin/frame_loop.h"

#include <algorithm>
#include <utility>

#include "runtime/assets/file_bytes.h"
#include "runtime/core/log.h"
#include "runtime/plugin/layers.h"
#include "runtime/world/impacts/break_through.h"
#include "runtime/world/impacts/impact_damage.h"

namespace rubble {
namespace {

constexpr uint64_t kFollowsNone = ~uint64_t(0);

}  // namespace

FrameLoop::FrameLoop(const FrameLoopSettings& settings)
    : m_world(settings.worldId, settings.firstGeneration),
      m_givenPhysics(settings.physics),
      m_hostParallelFor(settings.parallelFor),
      m_snapshots(settings.particles),
      m_publish(settings.publish),
      m_moveParticles(settings.moveParticles),
      m_waitForShadow(settings.waitForShadow) {
    useThreads(settings.physicsThreads);
    if (!settings.hostPhysics) m_physics = makePhysics(physicsSettings());
    if (settings.shadowVolume) m_shadow = std::make_unique<ShadowWorker>(settings.shadow);
    if (settings.copyShadow) m_shadowCopy = std::make_unique<ShadowCopy>();
}

FrameLoop::~FrameLoop() {
    endRecording();
}

/// Those of the host, or a pool of so many.
void FrameLoop::useThreads(int threads) {
    m_threads = threads > 1 && !m_hostParallelFor ? std::make_unique<ThreadPool>(threads) : nullptr;
    m_parallelFor = m_hostParallelFor ? m_hostParallelFor : serialFor;
    if (!m_threads) return;
    m_parallelFor = [pool = m_threads.get()](size_t count, const std::function<void(size_t)>& body) {
        pool->run(count, body);
    };
}

PhysicsSettings FrameLoop::physicsSettings() const {
    PhysicsSettings out = physicsPreset(m_preset, m_givenPhysics);
    out.parallelFor = m_threads || m_hostParallelFor ? m_parallelFor : m_givenPhysics.parallelFor;
    return out;
}

void FrameLoop::setPhysicsThreads(int threads) {
    useThreads(threads);
    if (m_physics) m_physics->setSettings(physicsSettings());
}

void FrameLoop::followPhysicsPreset() {
    if (std::exchange(m_preset, m_world.settings().physics) != m_preset) m_physics->setSettings(physicsSettings());
}

void FrameLoop::dropWaitingEdits() {
    if (const size_t count = m_edits.take().size())
        logWarning(std::to_string(count) + " edits that waited for the next step are dropped: the world is replaced");
}

void FrameLoop::load(const Level& level) {
    dropWaitingEdits();
    m_changes = {};
    m_pending.clear();
    forgetPlayed();
    m_world.load(level);
}

/// Another world is about to come.
void FrameLoop::forgetPlayed() {
    endRecording();
    forgetHostMotion();
    keepDeltas(std::nullopt);
    m_moved = {};
    m_followedStart = kFollowsNone;
    m_snapshots.particles().clear();
}

void FrameLoop::load(SavedGame game) {
    dropWaitingEdits();
    m_changes = {};
    forgetPlayed();
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

Result<Done> FrameLoop::save(const std::function<Result<Done>(std::span<const uint8_t>)>& write) {
    Result<Done> written = write(gameToBytes(savedGame(m_edits.waiting())));
    if (written) goOnAsLoaded(false);
    return written;
}

Result<Done> saveTo(const std::string& path, FrameLoop& loop) {
    return loop.save([&](std::span<const uint8_t> bytes) { return writeFileAtomically(path, bytes, kMaxFileBytes); });
}

void FrameLoop::goOnAsLoaded(bool dropMarks) {
    m_rebuildPhysics = true;
    m_world.resetCaches(dropMarks);
}

/// The queue of edits is not in the saved game that it begins with, because the first step records it.
Result<Done> FrameLoop::startRecording(const std::string& path) {
    Result<RecordingWriter> writer = RecordingWriter::open(path, savedGame({}));
    if (!writer) return Error{writer.error()};
    auto recording = std::make_unique<RecordingWriter>(std::move(*writer));
    auto recorder = std::make_unique<Recorder>(m_world, DeltaContent::All,
                                               [to = recording.get()](const RecordedStep& step) { to->add(step); });
    endRecording();  // from here on nothing throws
    goOnAsLoaded(true);
    forgetHostMotion();  // it is in the saved game
    m_recording = std::move(recording);
    m_recorder = std::move(recorder);
    return Done{};
}

Result<Done> FrameLoop::stopRecording() {
    if (!m_recording) return Done{};
    m_recorder.reset();
    const std::unique_ptr<RecordingWriter> writer = std::move(m_recording);
    if (!m_hostMotion.poses.empty() || !m_hostMotion.damage.empty()) writer->add(m_hostMotion);
    return writer->close();
}

/// Stops a recording that nobody waits for. Throws nothing: destructors and calls that may not fail use it.
void FrameLoop::endRecording() noexcept {
    try {
        if (const Result<Done> stopped = stopRecording(); !stopped) logError(stopped.error());
    } catch (const std::exception& error) {
        logError(error.what());
    }
}

bool FrameLoop::step(World::Follows follows) {
    if (follows == World::Follows::Nothing && m_recording) return false;
    Edits edits = m_edits.take();
    follows == World::Follows::Nothing ? stepAlone(edits) : stepWith(edits);
    m_edits.recycle(std::move(edits));
    return true;
}

void FrameLoop::replay(const RecordedStep& step) {
    m_rebuildPhysics = step.physicsRebuilt;
    if (m_rebuildPhysics) m_world.resetCaches();
    if (step.hostMotion) followHost(step.hostMotion->poses, {}, step.hostMotion->damage);
    stepWith(step.edits);
}

void FrameLoop::followHost(std::span<const BodyPose> poses, std::span<const Impact> impacts, const Edits& damage) {
    m_world.setPoses(poses);
    m_hostMotion.poses.insert(m_hostMotion.poses.end(), poses.begin(), poses.end());
    addHostDamage(damageOf(impacts));
    addHostDamage(damage);
    m_hostImpacts.insert(m_hostImpacts.end(), impacts.begin(), impacts.end());
}

void FrameLoop::addHostDamage(const Edits& damage) {
    m_pending.insert(m_pending.end(), damage.begin(), damage.end());
    m_hostMotion.damage.insert(m_hostMotion.damage.end(), damage.begin(), damage.end());
}

void FrameLoop::forgetHostMotion() {
    m_hostMotion.poses.clear();
    m_hostMotion.damage.clear();
    m_hostImpacts.clear();
}

void FrameLoop::stepWith(const Edits& hostEdits) {
    std::fill_n(m_times.ms.begin(), size_t(Stage::Apply), 0.0);  // the stages from Apply on are the render thread's
    m_followedStart = kFollowsNone;                              // a step of its own is none of those that it follows
    loadPhysics();
    applyEdits(hostEdits, World::Follows::All);
    m_physics ? stepPhysics() : followHostBodies();
    if (m_physics)
        publishStep(m_physics->poses(), m_physics->impacts());
    else
        publishStep(m_movedByHost, m_hostImpacts);
    forgetHostMotion();
}

/// A step in which no time passes. Physics is rebuilt by the next one in which it does, so that what is played follows
/// from the world alone. What impacts break waits for that one, unless an undo takes the impacts back.
void FrameLoop::stepAlone(const Edits& hostEdits) {
    std::fill_n(m_times.ms.begin(), size_t(Stage::Apply), 0.0);
    m_followedStart = kFollowsNone;
    Edits waiting = std::exchange(m_pending, {}), hostDamage = std::exchange(m_hostMotion.damage, {});
    applyEdits(hostEdits, World::Follows::Nothing);
    if (m_changes.isRestored) {
        std::erase_if(waiting, [](const Edit& edit) { return !edit.made; });
        hostDamage.clear();
    }
    m_pending = std::move(waiting), m_hostMotion.damage = std::move(hostDamage);
    m_rebuildPhysics = true;
    recordMotion({}, {});
    publishStep({}, {});
}

/// What the step has changed; the whole world where a renderer has seen nothing yet.
void FrameLoop::publishStep(std::span<const BodyPose> moved, std::span<const Impact> impacts) {
    moved = changedPoses(moved);
    if (!m_mustPublishAll.exchange(false)) return publish(m_changes, moved, impacts);
    FrameChanges all = m_changes;
    all.levelReplaced = true;
    publish(all, moved, impacts);
}

/// Before the edits, so that physics can tell what they change.
void FrameLoop::loadPhysics() {
    if (!m_physics || (!m_rebuildPhysics && !m_world.data().levelReplaced)) return;
    const ScopedTimer timer(m_times[Stage::Physics]);
    m_physics->load(m_world);
}

void FrameLoop::applyEdits(const Edits& hostEdits, World::Follows follows) {
    const ScopedTimer timer(m_times[Stage::ApplyEdits]);
    m_changes = m_world.applyEdits(hostEdits, std::exchange(m_pending, {}), follows);
    recordEdits(hostEdits);
    m_rebuildPhysics = false;
}

void FrameLoop::stepPhysics() {
    {
        const ScopedTimer timer(m_times[Stage::Physics]);
        followPhysicsPreset();
        m_physics->apply(m_changes, m_world);
        m_physics->step();
    }
    {
        const ScopedTimer timer(m_times[Stage::Poses]);
        copyMotion(*m_physics, m_world);
        recordMotion(m_physics->poses(), m_physics->characters());
    }
    const ScopedTimer timer(m_times[Stage::Impacts]);
    m_pending = damageOf(m_physics->impacts());
    for (const JointHandle joint : m_physics->jointBreaks())
        m_pending.emplace_back(RemoveJointEdit{joint, JointBreak::Force});
}

void FrameLoop::followHostBodies() {
    const ScopedTimer timer(m_times[Stage::Poses]);
    readHostMotion();
    recordMotion(m_movedByHost, {});
}

/// Where the bodies are now that the host has moved before the edits of this step, which may have moved them on.
void FrameLoop::readHostMotion() {
    m_movedByHost.clear();
    for (const BodyPose& moved : m_hostMotion.poses) addPose(moved.body, m_movedByHost);
}

void FrameLoop::recordEdits(const Edits& hostEdits) {
    for (Recorder* recorder : {m_recorder.get(), m_deltaRecorder.get()}) {
        if (!recorder) continue;
        recorder->recordEdits(hostEdits, m_changes, m_world, m_rebuildPhysics);
        if (!m_physics) recorder->recordHostMotion(m_hostMotion);
    }
}

void FrameLoop::recordMotion(std::span<const BodyPose> poses, std::span<const CharacterMove> characters) {
    for (Recorder* recorder : {m_recorder.get(), m_deltaRecorder.get()})
        if (recorder) recorder->recordMotion(poses, characters, m_world);
    if (m_deltas) m_deltas->addEvents(m_changes);
}

/// What impacts and forces break is carried out in the next step: no stage runs twice in one.
Edits FrameLoop::damageOf(std::span<const Impact> impacts) const {
    Edits damage = impactDamage(m_world, impacts);
    addBreakThroughImpulses(m_world, impacts, damage);
    return damage;
}

void FrameLoop::addPose(BodyHandle handle, std::vector<BodyPose>& out) const {
    if (const Body* body = m_world.bodies().find(handle))
        out.push_back({handle, body->pose, body->velocity, body->angularVelocity, body->asleep, body->waitsToWake});
}

std::span<const BodyPose> FrameLoop::changedPoses(std::span<const BodyPose> moved) {
    if (m_changes.teleported.empty()) return moved;
    m_changedPoses.assign(moved.begin(), moved.end());
    for (const BodyHandle handle : m_changes.teleported) addPose(handle, m_changedPoses);
    return m_changedPoses;
}

void FrameLoop::publish(const FrameChanges& changes, std::span<const BodyPose> moved, std::span<const Impact> impacts) {
    m_moved = moved;
    const std::lock_guard lock(m_publishing);  // a draw() before publish() would take this step's patches
    if (m_shadow) {
        const ScopedTimer timer(m_times[Stage::Shadow]);
        m_shadow->submit(changes, moved, m_world);
    }
    const ScopedTimer timer(m_times[Stage::Publish]);
    if (!m_publish && m_moveParticles) m_snapshots.stepParticles(changes, impacts, m_world);
    if (!m_shadow) {
        if (m_publish) m_snapshots.publishWithoutShadow(changes, moved, m_world, impacts);
        return;
    }
    if (m_waitForShadow) m_shadow->waitFor(changes.step);
    std::vector<ShadowPatches> patches = m_shadow->takePatches();
    if (m_shadowCopy) {
        m_shadowCopy->follow(std::exchange(m_released, {}));
        m_shadowCopy->follow(patches);
    }
    if (m_publish) m_snapshots.publish(changes, moved, m_world, std::move(patches), impacts);
}

/// Between two steps, as in a pause, the shadow volume of the last one is finished with nobody to publish it.
void FrameLoop::releaseFinished() {
    const std::unique_lock lock(m_publishing, std::try_to_lock);
    if (!lock || !m_shadow || !m_snapshots.isWaiting()) return;
    std::vector<ShadowPatches> patches = m_shadow->takePatches();
    if (m_shadowCopy) m_released.insert(m_released.end(), patches.begin(), patches.end());
    m_snapshots.release(std::move(patches));
}

void FrameLoop::restartDrawing() {
    m_awaitsAll = true;
    m_mustPublishAll = true;
}

}  // namespace rubble
