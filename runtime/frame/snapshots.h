#pragma once
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "runtime/frame/frame_snapshot.h"
#include "runtime/frame/glow_lights.h"
#include "runtime/frame/particles.h"
#include "runtime/frame/ripples.h"
#include "runtime/frame/shown_palettes.h"
#include "runtime/frame/snapshot_merger.h"
#include "runtime/world/world.h"

namespace rubble {

/// Turns the journal into snapshots for the renderer. A step's snapshot waits until the shadow volume has reached that
/// step and is then posted together with the volume's patches: what is drawn is one version of the world throughout.
class Snapshots {
public:
    /// Without particles.
    Snapshots() : Snapshots(ParticleSettings{.maxAlive = 0}) {}
    /// With particles as set.
    explicit Snapshots(const ParticleSettings& particles) : m_particles(particles) {}

    /// [main-thread] `moved` are the poses that physics has just handed over and `impacts` its hard contacts; `patches`
    /// is what the shadow worker published since the last call. Never waits. A step in which nothing happens posts
    /// nothing and allocates nothing.
    void publish(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world,
                 std::vector<ShadowPatches> patches, std::span<const Impact> impacts = {});
    /// Whether a snapshot waits for its shadow. [a thread that no publish() runs beside]
    bool isWaiting() const { return !m_waiting.empty(); }
    /// Posts what waits for these patches: what publish() does with what came since the last step, between two steps.
    /// Patches come in the order in which the worker published them. [a thread that no publish() runs beside]
    void release(std::vector<ShadowPatches> patches);
    /// [main-thread] As publish() where no shadow worker is used: nothing waits.
    void publishWithoutShadow(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world,
                              std::span<const Impact> impacts = {});
    /// [main-thread] For worlds of which nothing is published: moves the particles by a step.
    void stepParticles(const FrameChanges& changes, std::span<const Impact> impacts, const World& world);
    /// [main-thread] The particles, to list them or to add some.
    Particles& particles() { return m_particles; }
    /// [render-thread] All posted snapshots merged into one, or nothing. While nobody takes them, each is merged once.
    std::optional<FrameSnapshot> take();

private:
    struct Waiting {
        FrameSnapshot snapshot;
        bool needsShadow;  ///< the step also changed the shadow volume
    };
    /// A shape's newest pose in a snapshot. Indexed by the shape's slot.
    struct LastPose {
        ShapeHandle shape;
        Pose pose;
        uint64_t listedIn = 0;  ///< m_count of the last snapshot that holds its pose
    };
    void enqueue(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world,
                 std::span<const Impact> impacts);
    void addCreated(const FrameChanges& changes, const World& world, FrameSnapshot& out);
    void addChanged(const FrameChanges& changes, const World& world, FrameSnapshot& out);
    void addPoses(std::span<const BodyPose> moved, const World& world, FrameSnapshot& out);
    bool hasJumped(ShapeHandle shape, const World& world, const Pose& from, const Pose& to) const;
    /// Adds a shape's pose, unless the snapshot holds it already.
    void addPose(ShapeHandle shape, const World& world, FrameSnapshot& out);
    void addParticles(const FrameChanges& changes, std::span<const Impact> impacts, const World& world,
                      FrameSnapshot& out);
    void addRipples(std::span<const BodyPose> moved, const World& world, FrameSnapshot& out);
    /// Brings m_lights up to date; whether it has changed.
    bool updateLights(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world);
    void addRopes(const World& world, FrameSnapshot& out);
    /// Lists all lights of the world, of fires and of particles, if any of them has changed.
    void listLights(FrameSnapshot& out, bool worldChanged);
    void addFires(const FrameChanges& changes, const World& world);
    /// The oldest snapshot that waits, without its shadow.
    FrameSnapshot takeOldest();
    void post(std::optional<FrameSnapshot> snapshot);

    std::deque<Waiting> m_waiting;        ///< oldest first
    std::mutex m_mutex;                   ///< of the two that follow
    SnapshotMerger m_backlog;             ///< what has not been drawn for long
    std::vector<FrameSnapshot> m_posted;  ///< what came after it, oldest first
    std::vector<FrameSnapshot> m_taken;   ///< [render-thread] those that take() has merged last
    std::vector<LastPose> m_lastPoses;
    uint64_t m_count = 0;                   ///< of calls of enqueue()
    uint64_t m_newestStep = 0;              ///< of the last of them
    std::vector<BodyHandle> m_placed;       ///< whose pose or motion an edit or undo has set in this step, ascending
    std::vector<ShapeHandle> m_moving;      ///< shapes that the newest snapshot shows moving
    std::vector<ShapeHandle> m_moved;       ///< the same while it is being made
    std::vector<BodyHandle> m_lightBodies;  ///< that carry a light, ascending
    std::vector<SnapshotLight> m_lights;    ///< of the world, what glows in it and its fires
    GlowLights m_glow;
    bool m_hadGlow = false;  ///< the newest list of lights has some of particles
    std::optional<Environment> m_environment;
    ShownPalettes m_palettes;
    Particles m_particles;
    Ripples m_ripples;
    std::vector<SnapshotRope> m_ropes;  ///< as the newest snapshot shows them
    std::vector<Fire> m_fires;          ///< that burn now: they feed the particles
};

}  // namespace rubble
