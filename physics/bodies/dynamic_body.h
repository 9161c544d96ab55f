#pragma once
#include "physics/bodies/limits.h"
#include "physics/bodies/sleep_timer.h"
#include "physics/collision/broadphase.h"
#include "physics/solver/contact_solver.h"
#include "runtime/world/world.h"

namespace rubble {

/// A dynamic body of World as physics moves it. Its frame is the centre of mass in principal axes. Asleep, it is in the
/// broadphase and in nothing else: it costs nothing until something comes near.
class DynamicBody {
public:
    DynamicBody(const World& world, BodyHandle handle);
    DynamicBody(const DynamicBody&) = delete;
    DynamicBody& operator=(const DynamicBody&) = delete;

    /// Takes over that its shapes' voxels have changed, with its mass and frame, and is awake as if made anew; false,
    /// and nothing has changed, if its shapes or their cells are not the same any more.
    bool updateShape(const World& world, const FrameChanges& changes);

    void setFilter(ShapeHandle shape, CollisionFilter filter);
    void setAsleep(bool asleep);
    bool asleep() const { return m_asleep; }
    void quarantine() { m_quarantined = true; }
    bool quarantined() const { return m_quarantined; }
    /// No NaN, no infinity, nothing absurd: numbers to compute with.
    bool finite() const;
    bool isFartherThan(double distance, glm::dvec3 origin) const;
    /// Brings what is beyond the envelope back to it; true if anything was. counts: by kind.
    bool clamp(LimitCounts& counts);
    /// Where the last finite step left it.
    void restore();

    /// The body's frame in the world, its motion and sleep, as of the last refresh.
    const BodyPose& state() const { return m_state; }
    /// Takes the state from the motion; false if nothing differs.
    bool refresh();

    BodyHandle handle() const { return m_handle; }
    const MassProperties& mass() const { return m_mass; }
    /// Half the smallest side of the collider's bounds, metres.
    double minHalfExtent() const { return m_minHalfExtent; }
    /// The body's frame in that of the motion.
    const Pose& bodyInCenter() const { return m_bodyInCenter; }
    Pose pose() const { return {motion.position, motion.rotation}; }
    /// Of World's frame of the body.
    Pose bodyPose() const { return pose() * m_bodyInCenter; }
    /// The collision object follows the motion.
    void setPose() { object.setPose(pose()); }
    void applyImpulse(glm::dvec3 impulse, glm::dvec3 position);

    CollisionObject object;
    SolverBody motion;
    SleepTimer sleepTimer;
    double slowSeconds = 0.0;           ///< how long it has been slow: the longer, the more drift counts as restTime
    bool newlyAwake = true;             ///< has not moved noticeably since it woke
    glm::dvec3 secondaryVelocity{0.0};  ///< m/s that fast hits may add within this step
    std::vector<uint32_t>
        sleepersTouched;      ///< slots of sleeping bodies that it has touched since it last moved noticeably
    bool touching = false;    ///< had a contact in the last step
    bool inWater = false;     ///< was in water in the last step
    bool isDebris = false;    ///< counts in the budget of what moves
    bool settled = false;     ///< a touch does not wake it
    bool wantsSleep = false;  ///< it is restTime, but what it is jointed to may not be
    bool known = false;       ///< its pairs of this step have been found

private:
    /// Mass, frame and motion from World; the collider's parts are placed about the centre.
    void takeState(const World& world);

    BodyHandle m_handle;
    std::vector<ShapeHandle> m_shapes;  ///< of the collider's parts
    MassProperties m_mass;
    Pose m_bodyInCenter;
    bool m_hasOddMass = false;  ///< World's is beyond the envelope
    BodyPose m_state;
    double m_minHalfExtent = 0.0;
    bool m_asleep = false;
    bool m_quarantined = false;
};

}  // namespace rubble
