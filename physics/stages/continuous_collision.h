#pragma once
#include <vector>

#include "physics/joints/joint_table.h"
#include "physics/stages/physics_bodies.h"
#include "physics/stages/physics_settings.h"

namespace rubble {

/// Continuous collision after the solve: no body ends a step on the other side of what it met.
class ContinuousCollision {
public:
    /// Moves bodies back along their path of this step to where they first entered something. Their velocities stay,
    /// and the next step finds the contact. gravity: m/s2.
    /// Returns whether there were any.
    bool stop(PhysicsBodies& bodies, const JointTable& joints, const PhysicsSettings& settings,
              const glm::dvec3& gravity);

private:
    double fractionOf(DynamicBody& body, PhysicsBodies& bodies, const JointTable& joints);
    bool stopAt(uint32_t slot, double fraction);
    void stopJointed(const PhysicsBodies& bodies, const JointTable& joints);

    struct Stop {
        uint32_t slot;
        double fraction;  ///< of the step
    };
    std::vector<Stop> m_stops;
    std::vector<CollisionObject*> m_found;
    std::vector<ObjectPair> m_pairs;
};

}  // namespace rubble
