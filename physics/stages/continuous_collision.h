#pragma once
#include <compare>
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
    /// A body stops where it has come to after this fraction of the step.
    struct Stop {
        double fraction;
        uint32_t slot;
        auto operator<=>(const Stop&) const = default;
    };
    /// A body that is swept. innerOnly: against what it is in, and what is in it.
    struct Swept {
        uint32_t slot;
        bool innerOnly;
    };
    void findSwept(PhysicsBodies& bodies, double seconds);
    void findPairs(const DynamicBody& body, const WorldBox& box, PhysicsBodies& bodies, const JointTable& joints);
    double fractionOf(const Swept& swept, PhysicsBodies& bodies, const JointTable& joints);
    void stopAt(const DynamicBody& body, double fraction);
    void stopJointed(const DynamicBody& body, const PhysicsBodies& bodies, const JointTable& joints);
    void stopFollowers(const DynamicBody& body, PhysicsBodies& bodies, const JointTable& joints);
    void putBack(DynamicBody& body, double fraction, const glm::dvec3& gravity) const;

    std::vector<Swept> m_swept;
    std::vector<double> m_fractions;  ///< by solver index: where it stops; above 1: it does not
    std::vector<Stop> m_queue;        ///< a heap, the first on top: what it holds up is still to be found
    std::vector<CollisionObject*> m_found;
    std::vector<ObjectPair> m_pairs;
    std::vector<Pose> m_rest;  ///< of a path
};

}  // namespace rubble
