#pragma once
#include <vector>

#include "physics/bodies/collision_object.h"
#include "physics/bodies/limits.h"
#include "physics/bodies/sleep_timer.h"
#include "physics/bodies/solver_body.h"
#include "runtime/world/world.h"

namespace rubble {

/// What pressed on a body when it fell asleep, and how that changes. See loads.h.
struct SleepLoad {
    struct Neighbour {
        uint32_t slot;
        glm::dvec3 impulse;    ///< in a substep, N s
        int stepsToLearn = 0;  ///< in which the impulse is still to be found: see loads.cpp
    };
    std::vector<Neighbour> neighbours;
    bool isNoted = true;     ///< false in the step in which it fell asleep
    glm::dvec3 change{0.0};  ///< by what awake neighbours press otherwise, N s
    int changedSteps = 0;    ///< for which it has been large
    uint64_t step = 0;       ///< in which it was last computed
};

/// A dynamic body of World as physics moves it. The frame of `motion` is the centre of mass in principal axes; World's
/// frame of the body is elsewhere. A sleeping body is in the broadphase and in nothing else, so it costs nothing until
/// something comes near. [main-thread]
class DynamicBody {
public:
    /// Copies the body from World. It is awake and in no broadphase.
    DynamicBody(const World& world, BodyHandle handle);
    DynamicBody(const DynamicBody&) = delete;
    DynamicBody& operator=(const DynamicBody&) = delete;

    /// Takes over a change of its motion and of its shapes' voxels, with the new mass and frame, and wakes. False,
    /// without a change, if it has other shapes now or shapes of other size.
    bool update(const World& world, const FrameChanges& changes);

    /// Forgets what it did: it goes on from what World knows, as if it had been made so, awake or asleep as it is.
    void forgetMotion(const World& world);

    /// The part of its collider that is one of its shapes; null: it is none of them.
    ColliderPart* partOf(ShapeHandle shape) const;
    /// The shapes of the collider's parts, in their order.
    const std::vector<ShapeHandle>& shapes() const { return m_shapes; }
    /// Puts it to sleep, with velocities of 0, or wakes it, with a new sleep timer. The broadphase is not told.
    void setAsleep(bool asleep);
    /// Makes it rest again before it may sleep: what acts on it has changed.
    void restartRest();
    /// See setAsleep().
    bool asleep() const { return m_asleep; }
    /// Takes it out of the simulation for good; see quarantined().
    void quarantine() { m_quarantined = true; }
    /// Whether it is not simulated, because its numbers were invalid.
    bool quarantined() const { return m_quarantined; }
    /// Whether pose and velocities can be computed with: no NaN and no infinity.
    bool finite() const;
    /// Whether a coordinate of its centre of mass is more than `distance` metres from that of a world position.
    bool isFartherThan(double distance, glm::dvec3 origin) const;
    /// Clamps speed and spin to the limits; true if anything was beyond, mass included. counts: incremented by kind.
    bool clamp(LimitCounts& counts);
    /// Slows it down by its damping. Returns joules: what its motion lost, below 0.
    double damp(double seconds);
    /// Goes back to the pose of the last refresh(), at rest.
    void restore();

    /// What World is to know, as of the last refresh().
    const BodyPose& state() const { return m_state; }
    /// Updates state(); false if nothing has changed.
    bool refresh();

    /// World's handle.
    BodyHandle handle() const { return m_handle; }
    /// Mass (kg), centre and principal inertia (kg m2); the mass is clamped to the limits.
    const MassProperties& mass() const { return m_mass; }
    /// Half the smallest side of the collider's bounds, metres: the radius of the inscribed sphere that may tunnel.
    double minHalfExtent() const { return object.minHalfExtent; }
    /// The pose of World's frame of the body in the frame of `motion`.
    const Pose& bodyInCenter() const { return m_bodyInCenter; }
    /// The world pose of the centre of mass, in principal axes.
    Pose pose() const { return {motion.position, motion.rotation}; }
    /// The world pose of World's frame of the body.
    Pose bodyPose() const { return pose() * m_bodyInCenter; }
    /// Moves the collision object to pose().
    void setPose() { object.setPose(pose()); }
    /// Changes the velocities by an impulse (N s) at a position, both in world space.
    void applyImpulse(glm::dvec3 impulse, glm::dvec3 position);

    CollisionObject object;
    SolverBody motion;
    SleepTimer sleepTimer;
    bool newlyAwake = true;                 ///< has not moved noticeably since it woke
    bool isPlaced = false;                  ///< the last edit of it has put it elsewhere
    bool wakesLoad = true;                  ///< it has woken or its support has changed: what it bears wakes too
    SleepLoad sleepLoad;                    ///< while it sleeps
    bool isAsLoaded = false;                ///< has not moved since physics was made from World
    SolverBody stepStart;                   ///< its motion before the last solve
    std::vector<Pose> stepPath;             ///< its poses in the last solve: at equal times, two or more
    int held = 0;                           ///< steps in which continuous collision holds it, then lets it pass
    int stuckSteps = 0;                     ///< steps in a row in which it made no progress
    bool isPenetrating = false;             ///< the last solve left one of its contacts deep
    std::vector<uint32_t> sleepersTouched;  ///< slots of bodies that it must wake when it moves
    bool touching = false;                  ///< had a contact in the last step
    bool inWater = false;                   ///< was in water in the last step
    uint32_t waterSlot = 0;                 ///< of that water, of several the lowest
    double gravityScale = 1.0;              ///< of World's body, as what follows
    double linearDamping = 0.0, angularDamping = 0.0;
    bool isDebris = false;    ///< counts in the budget of awake debris
    bool settled = false;     ///< only a hard hit wakes it
    bool waits = false;       ///< to wake: see AwakeBodies
    bool rests = false;       ///< is at rest: see SleepTimer
    bool wantsSleep = false;  ///< may sleep, but what it is jointed to may not
    int solverIndex = 0;      ///< in the solver's list of bodies, if it is awake
    bool pairsFound = false;  ///< contact detection has searched its pairs in this step

private:
    /// Takes mass, frame and motion from World and moves the collider's parts to the new centre of mass.
    void takeState(const World& world);
    void forgetContacts();

    BodyHandle m_handle;
    std::vector<ShapeHandle> m_shapes;  ///< of the collider's parts
    MassProperties m_mass;
    Pose m_bodyInCenter;
    bool m_hasClampedMass = false;  ///< and it was not counted yet
    BodyPose m_state;
    bool m_asleep = false;
    bool m_quarantined = false;
};

/// The velocity of an object at a point, world, m/s; 0 for what is static or asleep.
glm::dvec3 velocityAt(const CollisionObject& object, const glm::dvec3& point);

/// Whether one of two objects may be inside of the other, behind thin walls: not of a round one, nor of one part whose
/// rows of voxels have no gap as wide as the other's smallest side.
bool mayBeInside(const CollisionObject& a, const CollisionObject& b);

/// Whether two objects may be past each other, or through each other's walls, after a relative displacement (metres).
/// Always if one is static or asleep. Two moving bodies that still overlap are not: their contacts part them.
bool mayPass(const CollisionObject& a, const CollisionObject& b, double displacement);

}  // namespace rubble
