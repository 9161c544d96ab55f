#pragma once
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <optional>

#include "physics/collider.h"
#include "physics/settling.h"
#include "runtime/world/world.h"

namespace rubble {

/// More boxes than this on one shape, and its collider is made from the shape at half the resolution, or a quarter, ...
inline constexpr size_t kMaxBoxes = 2048;

/// A dynamic body of World as a Bullet body, whose frame is the centre of mass in principal axes.
/// Asleep it is a static object to Bullet: it costs nothing and joins no island until something wakes it.
class DynamicBody {
public:
    DynamicBody(const World& world, BodyHandle handle, glm::dvec3 origin);
    DynamicBody(const DynamicBody&) = delete;
    DynamicBody& operator=(const DynamicBody&) = delete;

    /// Static (asleep) or dynamic to Bullet. The body must be out of Bullet's world.
    void setAsleep(bool asleep);
    /// Lets a sleeping body that is in Bullet's world take part in this substep's solve; true if it slept.
    bool wakeInPlace();
    bool asleep() const { return m_asleep; }
    void quarantine() { m_quarantined = true; }
    bool quarantined() const { return m_quarantined; }
    /// No NaN, no infinity, nothing absurdly far or fast.
    bool finite() const;
    /// Where the last finite step left it.
    void restore(glm::dvec3 origin);

    /// The body's frame in the world, its motion and sleep, as of the last refresh.
    const BodyPose& state() const { return m_state; }
    /// Takes the state from Bullet; false if nothing differs.
    bool refresh(glm::dvec3 origin);

    BodyHandle handle() const { return m_handle; }
    btRigidBody& rigid() { return *m_rigid; }
    const btRigidBody& rigid() const { return *m_rigid; }
    int boxCount() const { return m_collider->boxCount(); }
    const MassProperties& mass() const { return m_mass; }
    /// Half the smallest side of the collider's bounds, metres.
    double reach() const { return m_reach; }

    Settling settling;
    double slowSeconds = 0.0;               ///< how long it has been slow: the longer, the more drift counts as calm
    bool freshlyAwake = true;               ///< has not moved noticeably since it woke
    std::vector<uint32_t> sleepersTouched;  ///< slots of sleeping bodies that it has touched since it last moved noticeably
    bool touching = false;                  ///< had a contact in the last substep
    bool isDebris = false;                  ///< counts in the budget of what moves
    bool settled = false;                   ///< a touch does not wake it
    bool readd = false;                     ///< was woken in place: Bullet's lists do not know yet

private:
    std::vector<ColliderBox> collectBoxes(const World& world, const Body& body, SurfaceSum& surface) const;

    BodyHandle m_handle;
    MassProperties m_mass;
    Pose m_centerInBody;  ///< principal frame -> body frame
    Pose m_bodyInCenter;
    BodyPose m_state;
    std::optional<Collider> m_collider;
    std::optional<btRigidBody> m_rigid;
    btVector3 m_inertia;
    double m_reach = 0.0;
    bool m_asleep = false;
    bool m_quarantined = false;
};

}  // namespace rubble
