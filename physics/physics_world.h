#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "physics/bodies/limits.h"
#include "runtime/core/parallel_for.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/world.h"

namespace rubble {

/// Which bodies keep their angular momentum in free rotation; the others keep their angular velocity.
enum class RotationRule : uint8_t { Never, WhereNeeded, Always };

struct PhysicsSettings {
    int substeps = 6;                 ///< of 1/60 s, in which contacts are solved; they are found once a step
    int iterations = 1;               ///< over the contacts in each half of a substep
    double stepSeconds = 1.0 / 60.0;  ///< of a step; the frame loop counts on this, measurements take others
    double contactHertz = 90.0;       ///< stiffness of contacts; at most a quarter of the rate of substeps counts
    double loadBearingRatio =
        30.0;                   ///< how many times as heavy what lies on a body must be for its contacts to be stiffer
    int loadBearingPasses = 8;  ///< over such contacts, more than over others; 0: none is stiffer
    double contactMargin = 0.02;   ///< metres apart at which bodies count as touching
    bool continuous = true;        ///< what is fast is swept
    double sweepThreshold = 0.02;  ///< metres that something must move in a step for that
    RotationRule rotation = RotationRule::WhereNeeded;
    double sleepVelocity = 0.02;  ///< m/s of drift, averaged over sleepTime, below which a touching body falls asleep
    double sleepAngularVelocity = 0.04;  ///< rad/s
    double sleepTime = 0.5;              ///< s of restTime before it does
    double slowDamping = 0.01;      ///< share of the speeds of a touching body below 0.3 m/s lost a step, and again for
                                    ///< each second of being so slow
    double impactThreshold = 50.0;  ///< N s below which a contact is not reported
    double impactSpeed = 0.5;       ///< m/s of approach below which it counts as resting and is not reported
    ParallelFor parallelFor;        ///< none: one thread; results do not depend on it
};

/// Presets: settings to start from; every one can still be set by itself. What each holds is measured by the scenes of
/// tests/physics/scenes: towers of half-metre cubes that nothing lets sleep for 30 s, how much heavier a cube may be
/// than the one that it lies on and sinks by less than 1 cm.
///   fast       16 cubes awake (20 with sleep), 100 times as heavy, spin keeps its velocity instead of its momentum
///   balanced   the default: 25 cubes awake (60 with sleep), 1,000 times as heavy, momentum and energy of free spin
///   kept accurate   30 cubes awake (60 with sleep), 3,000 times as heavy, what is slow is not damped
PhysicsSettings fastPhysics();
PhysicsSettings balancedPhysics();
PhysicsSettings accuratePhysics();

struct PhysicsStats {
    int bodies = 0, awake = 0;
    int pairs = 0, contacts = 0;  ///< of bodies that touch, and their points, in the last step
    LimitCounts clamped{};        ///< how often what was beyond the envelope, by kind, since the beginning
};

/// Rigid bodies made of voxels: who moves, who isConstrained whom, who rests. Positions are double; what is near is
/// compared in toFloat4 about each pair, and broadphase about an origin chosen when a level is loaded. [main-thread]
class PhysicsWorld {
public:
    explicit PhysicsWorld(const PhysicsSettings& settings = {});
    ~PhysicsWorld();
    PhysicsWorld(const PhysicsWorld&) = delete;
    PhysicsWorld& operator=(const PhysicsWorld&) = delete;

    /// Creates, destroys and re-shapes bodies as the journal says, then applies its impulses; a piece starts with its
    /// parent's motion (v + w x r, w), which World has already set. rebuild: everything is made from the World in slot
    /// order, as after levelReplaced: nothing of the past counts any more.
    void apply(const FrameChanges& changes, const World& world, bool rebuild = false);
    /// settings.stepSeconds further.
    void step();
    /// Bodies that moved, fell asleep or woke in the last step, in slot order; valid until the next step().
    std::span<const BodyPose> poses() const;
    /// Characters that moved or changed in the last step, in slot order; valid until the next step().
    std::span<const CharacterMove> characters() const;
    /// Hits harder than the threshold in the last step, one for each pair of bodies and substep, in a fixed order; the
    /// normal points from `other` to `body`. Valid until the next step().
    std::span<const Impact> impacts() const;
    /// Joints that bore more in the last step than they can, in slot order; valid until the next step().
    std::span<const JointHandle> jointBreaks() const;
    /// Where the ropes are that moved in the last step, in slot order; valid until the next.
    std::span<const RopeMotion> ropes() const;
    PhysicsStats stats() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace rubble
