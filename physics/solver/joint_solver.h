#pragma once
#include <array>
#include <span>
#include <vector>

#include "physics/solver/geometric_stiffness.h"
#include "physics/solver/joint_rows.h"
#include "physics/solver/joint_system.h"
#include "physics/solver/joint_work.h"

namespace rubble {

/// Solves joints within the substeps of ContactSolver. See joint_solver.cpp for the method.
class JointSolver {
public:
    /// Begins a step; marks the states of jointed bodies. The constraints must stay until its end.
    void begin(std::span<JointConstraint* const> joints, std::span<SolverState> states);
    /// Begins a substep of this length: computes rows and masses where the bodies are, and warm starts. fall: m/s that
    /// gravity gave what falls freely in this substep.
    void prepare(std::span<const SolverBody> bodies, std::span<SolverState> states, const glm::dvec3& fall,
                 double seconds);
    /// Call when the bodies have moved: computes rows and masses where they are now.
    void followMove(std::span<const SolverBody> bodies, std::span<SolverState> states);
    /// A few iterations over all joints. useBias: before the bodies move, with correction of position errors; false:
    /// for velocities alone.
    void solve(std::span<const SolverBody> bodies, std::span<SolverState> states, bool useBias);
    /// Makes the velocities right after an impact, which no substep starts with again: the joints' impulses stay as
    /// they are.
    void solveImpact(std::span<const SolverBody> bodies, std::span<SolverState> states);
    /// Ends a substep: adds its impulses to the joints' mean force and torque over a step of stepSeconds, and to their
    /// work.
    void endSubstep(std::span<const SolverState> states, double stepSeconds);
    /// Whether there are no joints in this step.
    bool empty() const { return m_joints.empty(); }

private:
    void followArcs(std::span<const SolverBody> bodies, std::span<const SolverState> states, double minTurn,
                    double maxTurn);
    void prepareJoint(JointRows& e, SolverState& A, SolverState& B) const;
    void prepareFreeAxis(JointRows& e) const;
    void prepareServo(JointRows& e, const SolverState& A, const SolverState& B) const;
    static void dropImpulsesOfWhatIsOff(JointRows& e);
    static void warmStart(const JointRows& e, SolverState& A, SolverState& B);
    static void applyAlong(JointRows& e, const FreeAxis& axis, SolverState& A, SolverState& B, double impulse);
    void solveFreeAxis(JointRows& e, SolverState& A, SolverState& B, bool useBias) const;
    void solveConstraint(JointRows& e, SolverState& A, SolverState& B) const;
    void solveSpring(JointRows& e, SolverState& A, SolverState& B) const;
    void solveLimit(JointRows& e, SolverState& A, SolverState& B, bool isHigh, bool useBias) const;
    void solveBallFriction(JointRows& e, SolverState& A, SolverState& B) const;
    void brakeInTime(JointRows& e, const SolverState& A) const;
    void solveLockedRows(JointRows& e, SolverState& A, SolverState& B, bool useBias) const;
    void setLocked(JointRows& e, SolverState& A, SolverState& B, size_t first, glm::dvec3 impulse, double most) const;
    /// The impulses of a joint: see JointConstraint.
    struct Impulses {
        std::array<double, 6> locked;
        std::array<double, 2> limit;
        double spring, motor, friction;
        glm::dvec3 ballFriction;
    };
    /// Whether the joint's locked rows are not in the system.
    bool isSolvedAlone(const JointRows& e) const { return m_system.empty() || !e.isInSystem; }

    std::vector<JointRows> m_joints;
    std::vector<Impulses> m_saved;  ///< during solveImpact()
    JointSystem m_system;
    GeometricStiffness m_stiffness;
    JointWork m_work, m_impactWork;
    double m_seconds = 0.0;      ///< of the substep
    glm::dvec3 m_halfFall{0.0};  ///< m/s, half of what gravity gives in a substep
    bool m_isNew = true;         ///< the system is not built for these joints yet
};

}  // namespace rubble
