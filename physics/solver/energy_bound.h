#pragma once
#include <span>
#include <utility>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "physics/solver/joint_solver.h"
#include "runtime/core/union_find.h"

namespace rubble {

/// Contacts may take energy and hand it on, but give none: bodies that hang together by contacts, some of them with the
/// world, end a step with no more energy, weight included, than they began it with. What a solver adds anyway, where a
/// cut has left bodies inside what stands, is taken from the speeds of those that gained, in the shares in which they
/// did; height that is left then stays. Not held: what joints drive, and what isConstrained no world, whose momentum
/// would suffer.
class EnergyBound {
public:
    /// Before contacts are solved.
    void note(std::span<const SolverBody> bodies);
    /// After. pairs: bodies that have contacts; body 0 is the world. gravity: m/s2.
    void hold(std::span<SolverBody> bodies, std::span<const std::pair<int, int>> pairs,
              std::span<JointConstraint* const> joints, const glm::dvec3& gravity);

private:
    struct Island {
        double gain = 0.0, gains = 0.0;  ///< joules: of all together, and of those alone that gained
        bool touchesWorld = false, isDriven = false;
    };
    struct Before {
        double kinetic = 0.0;
        glm::dvec3 position{0.0};
    };
    std::vector<Before> m_before;   ///< by body
    std::vector<double> m_gains;    ///< joules, by body
    std::vector<Island> m_islands;  ///< by lowest body
};

}  // namespace rubble
