#pragma once
#include <cstdint>
#include <memory>

#include "physics/physics_world.h"
#include "render/renderer.h"
#include "runtime/core/profile.h"
#include "runtime/frame/snapshots.h"
#include "runtime/plugin/recorder.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/world/world.h"

namespace rubble {

struct FrameLoopSettings {
    uint8_t worldId = 1;  ///< part of every handle, so that one world's handle is not taken for another's
    PhysicsSettings physics;
    ShadowWorker::Mode shadow = ShadowWorker::Mode::Thread;
    bool shadowVolume = true;    ///< off: nothing is drawn with rays, and nothing is paid
    bool publish = true;         ///< off: for worlds that nobody draws
    ParticleSettings particles;  ///< for eyes only: they change nothing in the world
    bool waitForShadow = false;  ///< each step waits for its shadow volume: pictures that do not depend on timing
};

/// The two functions of a frame, and the only place that knows every module.
class FrameLoop {
public:
    explicit FrameLoop(const FrameLoopSettings& settings = {});

    void load(const Level& level);
    /// Continues what was saved.
    void load(SavedGame game);
    /// The game as it is now. Saving is an event: the next step makes physics anew from the World, as loading will, so
    /// that going on and loading are the same. The queue of edits is part of it.
    SavedGame save();
    /// Records every step from here on; it begins with a save. An error if the file cannot be written.
    Result<Done> startRecording(const std::string& path);
    /// Names the file. Nothing is wrong if nothing is recorded.
    Result<Done> stopRecording();
    bool isRecording() const { return m_recorder != nullptr; }
    /// A step of a recording again, from its edits: World and physics must be where they were, else the hashes differ.
    void replay(const RecordedStep& step);
    /// [main-thread] Exactly 1/60 s; the host or its clock decides how many.
    void step();
    /// [render-thread] alpha: how far between the last two steps.
    void draw(Renderer& renderer, const View& view, float alpha);

    EditQueue& edits() { return m_edits; }
    World& world() { return m_world; }
    PhysicsWorld& physics() { return m_physics; }
    ShadowWorker* shadow() { return m_shadow.get(); }
    /// The journal of the last step; valid until the next.
    const FrameChanges& changes() const { return m_changes; }
    const StageTimes& times() const { return m_times; }
    /// How many steps the shadow volume was behind when the last step was published, before any waiting.
    uint64_t shadowLag() const { return m_shadowLag; }

private:
    void stepWith(Edits hostEdits);
    void publish();
    /// The poses that physics has just handed over, and those of bodies that the journal put somewhere.
    std::span<const BodyPose> moved();

    World m_world;
    PhysicsWorld m_physics;
    std::unique_ptr<ShadowWorker> m_shadow;
    Snapshots m_snapshots;
    EditQueue m_edits;
    Edits m_pending;  ///< of the last step's impacts, and what waited when the game was saved: before the host's
    bool m_rebuildPhysics = false;
    std::unique_ptr<Recorder> m_recorder;
    FrameChanges m_changes;
    std::vector<BodyPose> m_moved;
    StageTimes m_times;
    uint64_t m_shadowLag = 0;
    bool m_publish;
    bool m_waitForShadow;
};

}  // namespace rubble
