#pragma once
#include <array>
#include <span>
#include <vector>

#include "physics/solver/joint_rows.h"

namespace rubble {

/// Counts what motors, springs and soft rows do in a part of a substep: JointConstraint::work.
class JointWork {
public:
    /// Begins before the impulses of the part act. early: m/s of the velocities in the part that gravity has given at
    /// this moment of the substep and had not given yet in its middle, where the energy of a swing is measured
    /// (energy_bound.cpp). isWhole: the joints' impulses of now act in the part, too.
    void begin(std::span<const JointRows> joints, std::span<const SolverState> states, const glm::dvec3& early,
               bool isWhole);
    /// Ends the part, and adds its work to the joints.
    void end(std::span<const JointRows> joints, std::span<const SolverState> states);
    /// As of begin().
    const glm::dvec3& early() const { return m_early; }

private:
    struct Start {
        double velocity = 0.0, impulse = 0.0;
    };
    std::vector<std::array<Start, 8>> m_starts;  ///< by joint: of the locked rows, the free axis and the motor's
    glm::dvec3 m_early{0.0};
};

}  // namespace rubble
