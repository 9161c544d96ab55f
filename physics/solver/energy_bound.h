#pragma once
#include <span>
#include <utility>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "physics/solver/joint_solver.h"
#include "runtime/core/union_find.h"

namespace rubble {

/// Keeps contacts from creating energy. Contacts may dissipate energy or pass it on, so an island of bodies in contact
/// must not end a step with more kinetic and potential energy than it had before. Where a cut has left bodies inside
/// each other the solver adds energy all the same; it is taken from the speeds of the bodies that gained, in proportion
/// to their gains, and then from their heights, but for half a millimetre a step: overlaps are pushed apart in the end.
/// Two kinds of islands are exempt: those with joints, which may be driven, and those that do not touch the world,
/// whose momentum would change.
class EnergyBound {
public:
    /// Call before the solve. bodies[0] is the world.
    void record(std::span<const SolverBody> bodies);
    /// Call after the solve. pairs: indices of bodies in contact. gravity: m/s2.
    void enforce(std::span<SolverBody> bodies, std::span<const std::pair<int, int>> pairs,
                 std::span<JointConstraint* const> joints, const glm::dvec3& gravity);

private:
    struct Island {
        double gain = 0.0;           ///< joules, of all its bodies
        double positiveGains = 0.0;  ///< joules, of the bodies that gained
        bool touchesWorld = false, hasJoints = false;
    };
    struct Before {
        double kinetic = 0.0;      ///< joules
        glm::dvec3 position{0.0};  ///< world, metres
    };
    std::vector<Before> m_before;   ///< by body
    std::vector<double> m_gains;    ///< joules, by body
    std::vector<Island> m_islands;  ///< by the island's root body
};

}  // namespace rubble
