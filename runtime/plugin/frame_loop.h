#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/physics_world.h"
#include "render/renderer.h"
#include "runtime/assets/delta_file.h"
#include "runtime/core/profile.h"
#include "runtime/core/thread_pool.h"
#include "runtime/frame/snapshots.h"
#include "runtime/plugin/recorder.h"
#include "runtime/shadow/shadow_copy.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/world/world.h"

namespace rubble {

struct FrameLoopSettings {
    uint8_t worldId = 1;           ///< 1 to 255, part of every handle, so that a handle of another world is recognised
    uint32_t firstGeneration = 1;  ///< of handles; see World
    /// No physics runs: the host says by followHost() how bodies move and what hits them. Joints,
    /// ropes and characters are data that nothing moves.
    bool hostPhysics = false;
    PhysicsSettings physics;
    int physicsThreads = 1;  ///< with the one that steps; above 1: they replace physics.parallelFor, with the same bits
    ParallelFor parallelFor;  ///< of a host, in place of physicsThreads; none: those
    ShadowWorker::Mode shadow = ShadowWorker::Mode::Thread;
    bool shadowVolume = true;    ///< false: nothing is drawn with rays, and step() does no work for them
    bool copyShadow = false;     ///< keeps the shadow volume for hosts that draw themselves
    bool publish = true;         ///< false: for worlds that nobody draws
    bool moveParticles = false;  ///< also where nothing is published
    ParticleSettings particles;  ///< particles are only drawn: they change nothing in the world
    bool waitForShadow = false;  ///< each step waits for its shadow volume: frames do not depend on timing
};

/// Pointers are null where nobody keeps it.
struct DrawingData {
    ShadowCopy* shadow = nullptr;    ///< the shadow volume as last published
    Particles* particles = nullptr;  ///< what is in the air
    /// Bodies that the last step moved, by physics, the host or edits: some twice, some gone by now. Valid until the
    /// next step; empty where the world was replaced.
    std::span<const BodyPose> moved;
};

/// A world with its physics, shadow volume and snapshots: the only class that knows every module. A frame calls step()
/// as often as time demands, then draw(). A library may lack physics and the renderer: see layers.h.
class FrameLoop {
public:
    /// Makes an empty world.
    explicit FrameLoop(const FrameLoopSettings& settings = {});
    ~FrameLoop();  ///< completes a recording; the log says what of it could not be written

    /// [main-thread] Replaces the world by a level. Drops the edits in the queue, with a warning, and stops a
    /// recording.
    void load(const Level& level);
    /// [main-thread] Replaces the world by a saved game and its queue of edits; those that wait here are dropped, with
    /// a warning. Stops a recording.
    void load(SavedGame game);
    /// [main-thread] The game as it is now, with its queue of edits. The next step rebuilds physics from the World, as
    /// loading does, so that playing on and loading give the same result.
    SavedGame save();
    /// [main-thread] The same as the bytes of a file for `write`. If it gives an error, nothing changes.
    Result<Done> save(const std::function<Result<Done>(std::span<const uint8_t>)>& write);
    /// [main-thread] Records every step from here on, beginning with a saved game. Stops a recording that is running;
    /// the log says what of that one could not be written. Undo reaches back to here only. The file gets its name in
    /// stopRecording(). If it cannot be written, nothing changes: a recording that is running goes on.
    Result<Done> startRecording(const std::string& path);
    /// [main-thread] Completes the file; without a recording it does nothing.
    Result<Done> stopRecording();
    /// [main-thread] From here on each step is kept for worlds that follow; none: no more, at no cost. withEvents: what
    /// followers cannot tell from the change of state too.
    void keepDeltas(std::optional<DeltaContent> content, bool withEvents = false);
    /// [main-thread] The steps that were kept; null: none are kept.
    DeltaWriter* deltas() { return m_deltas.get(); }
    /// [main-thread] Carries out what another world's deltas say, if this one is what that was before them: edits
    /// that wait here, and damage of this world's impacts, wait on. After an error the World is as after the last good
    /// step. Stops a recording, and deltas of this world. The next step() rebuilds physics. Deltas without motion leave
    /// that to followHost(). afterStep: called after each good step, when changes() is of that.
    Result<Done> follow(const Deltas& deltas, const std::function<void()>& afterStep);
    /// [main-thread] Repeats a recorded step from its edits and what the host's physics did before it. If World and
    /// physics are in the state before that step, the hash after it is the recorded one.
    void replay(const RecordedStep& step);
    /// [main-thread] Advances by exactly 1/60 s: queued edits, physics, damage by impacts, shadow volume, snapshot. Or
    /// nothing follows from the edits, and no time passes: false, without effect, while a recording runs, because its
    /// steps are whole.
    bool step(World::Follows follows = World::Follows::All);
    /// [main-thread] What the host's physics has done since the last step: where bodies are, then what hit what at the
    /// places where they are now. The next step breaks what those hits break. Stale handles are skipped. damage: what
    /// recorded hits break.
    void followHost(std::span<const BodyPose> poses, std::span<const Impact> impacts, const Edits& damage = {});
    /// [render-thread] Hands the newest snapshot to the renderer and draws. alpha in [0, 1]: interpolates between the
    /// poses of the last two steps.
    void draw(Renderer& renderer, const View& view, float alpha);

    /// [render-thread] Another renderer, which has seen nothing, will draw: the next step hands the whole world over,
    /// as the first after a level is loaded does. Until then draw() shows an empty world.
    void restartDrawing();

    /// The queue of the edits for the next step. [main-thread]
    EditQueue& edits() { return m_edits; }
    /// The same, to read it. [main-thread]
    const EditQueue& edits() const { return m_edits; }
    /// The world as the last step left it. [main-thread]
    World& world() { return m_world; }
    /// The same, to read it. [main-thread]
    const World& world() const { return m_world; }
    /// Runs work on the threads that the world's physics has. [main-thread]
    const ParallelFor& parallelFor() const { return m_parallelFor; }
    /// Gives physics so many threads, with the one that steps, from the next step on; those of a host's parallelFor
    /// stay. Results do not depend on it. [main-thread]
    void setPhysicsThreads(int threads);
    /// Its physics, for statistics and reports; null: the host moves the bodies. [main-thread]
    PhysicsWorld* physics() const { return m_physics.get(); }
    /// Keeps the shadow volume up to date; null without one. [main-thread]
    ShadowWorker* shadow() { return m_shadow.get(); }
    /// What hosts read to draw it themselves. [main-thread]
    DrawingData drawingData() {
        return {m_shadowCopy.get(), m_publish || m_moveParticles ? &m_snapshots.particles() : nullptr, m_moved};
    }
    /// The journal of the last step's edits; valid until the next step. Empty where the world was replaced.
    /// [main-thread]
    const FrameChanges& changes() const { return m_changes; }
    /// Wall-clock milliseconds of the stages of the last step [main-thread] and the last draw [render-thread].
    const StageTimes& times() const { return m_times; }

private:
    void useThreads(int threads);
    /// Those of the preset, on the threads in use.
    PhysicsSettings physicsSettings() const;
    /// Follows the preset of the world's settings.
    void followPhysicsPreset();
    void dropWaitingEdits();
    void forgetPlayed();
    SavedGame savedGame(const Edits& waiting) const;
    void goOnAsLoaded(bool dropMarks);
    void stepWith(const Edits& hostEdits);
    void stepAlone(const Edits& hostEdits);
    void loadPhysics();
    void applyEdits(const Edits& hostEdits, World::Follows follows);
    void stepPhysics();
    void followHostBodies();
    void addHostDamage(const Edits& damage);
    void forgetHostMotion();
    Edits damageOf(std::span<const Impact> impacts) const;
    /// Adds a body as it is now, if it is there.
    void addPose(BodyHandle handle, std::vector<BodyPose>& out) const;
    void publishStep(std::span<const BodyPose> moved, std::span<const Impact> impacts);
    void publish(const FrameChanges& changes, std::span<const BodyPose> moved, std::span<const Impact> impacts);
    void releaseFinished();
    void endRecording() noexcept;
    void recordEdits(const Edits& hostEdits);
    void recordMotion(std::span<const BodyPose> poses, std::span<const CharacterMove> characters);
    Result<Done> followStep(const RecordedStep& step, DeltaContent content, const StepEvents* events);
    Result<Done> followEmptyStep(const StepEvents* events);
    void readHostMotion();
    /// Those that have moved, and those of bodies that edits teleported.
    std::span<const BodyPose> changedPoses(std::span<const BodyPose> moved);

    World m_world;
    PhysicsSettings m_givenPhysics;
    PhysicsPreset m_preset = PhysicsPreset::Given;  ///< that physics has
    ParallelFor m_hostParallelFor;
    std::unique_ptr<ThreadPool> m_threads;    ///< of physics; null: it has none of its own
    ParallelFor m_parallelFor;                ///< on those threads, or the host's
    std::unique_ptr<PhysicsWorld> m_physics;  ///< null: the host moves the bodies
    std::unique_ptr<ShadowWorker> m_shadow;
    std::unique_ptr<ShadowCopy> m_shadowCopy;  ///< null: nobody asks for it
    std::vector<ShadowPatches> m_released;     ///< by draw(): the copy has not followed them yet
    std::mutex m_publishing;                   ///< of m_released, and of m_snapshots but for its mailbox
    Snapshots m_snapshots;
    EditQueue m_edits;
    /// Edits of the last step's impacts, and those that waited when the game was saved. They come before the host's.
    Edits m_pending;
    bool m_rebuildPhysics = false;        ///< in the next step
    HostMotion m_hostMotion;              ///< since the last step
    std::vector<Impact> m_hostImpacts;    ///< the same
    std::vector<BodyPose> m_movedByHost;  ///< in the last step
    std::unique_ptr<RecordingWriter> m_recording;
    std::unique_ptr<DeltaWriter> m_deltas;
    /// Of the recording and of the deltas; null: there is none.
    std::unique_ptr<Recorder> m_recorder, m_deltaRecorder;
    uint64_t m_followedStart = ~uint64_t(0);     ///< of the deltas that this world follows
    std::vector<PaletteRef> m_followedPalettes;  ///< that they brought
    FrameChanges m_changes;
    std::vector<BodyPose> m_changedPoses;
    std::span<const BodyPose> m_moved;
    StageTimes m_times;
    bool m_publish, m_moveParticles;
    bool m_waitForShadow;
    std::atomic<bool> m_mustPublishAll = false;  ///< in the next step
    bool m_awaitsAll = false;                    ///< [render-thread] the renderer has not seen the whole world
};

/// [main-thread] FrameLoop::save() into a file, whole or not at all. If it cannot be written, nothing changes.
Result<Done> saveTo(const std::string& path, FrameLoop& loop);

}  // namespace rubble
