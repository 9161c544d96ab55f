#pragma once
#include <span>
#include <vector>

#include "physics/solver/joint_rows.h"

namespace rubble {

/// Keeps light bodies stable that strong joints pull on. See geometric_stiffness.cpp for the method.
class GeometricStiffness {
public:
    /// Begins a step with so many bodies.
    void begin(size_t bodies);
    /// Begins a substep of this length, before anything is solved: sets the inverse inertia in the states of the bodies
    /// that would not be stable. The joints have the impulses of the last substep.
    void apply(std::span<const JointRows> joints, std::span<const SolverBody> bodies, std::span<SolverState> states,
               double seconds);

private:
    std::vector<double> m_turn;    ///< by body: (w h)^2 of the pulls on it
    std::vector<int> m_pulled;     ///< bodies of which that is not 0
    std::vector<bool> m_isSlowed;  ///< by body: in this step
};

}  // namespace rubble
