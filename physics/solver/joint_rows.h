#pragma once
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "physics/math/soft_constraint.h"
#include "runtime/world/objects/body_constraint.h"
#include "runtime/world/objects/joint.h"

namespace rubble {

inline constexpr double kMaxCorrectionSpeed = 10.0;  ///< m/s or rad/s at which a joint's position error is corrected

/// A joint between two of the solver's bodies. The impulses are those of a substep, N s or N m s: the next step starts
/// with them.
struct JointConstraint {
    const Joint* joint = nullptr;
    const BodyConstraint* constraint = nullptr;  ///< it joins nothing: this is the one row that there is
    JointHandle handle;
    std::array<int, 2> bodies{};            ///< of the solver; 0: the world
    std::array<Pose, 2> frames;             ///< of the joint's ends, in the bodies or in the world
    std::array<double, 6> lockedImpulse{};  ///< along the locked rows
    std::array<double, 2> limitImpulse{};   ///< of the low and the high limit
    double springImpulse = 0.0, motorImpulse = 0.0, frictionImpulse = 0.0;
    glm::dvec3 ballFriction{0.0};  ///< friction impulse of a ball or cone
    /// Of a position motor: the free coordinate at the start of the last substep. NaN: there was none.
    double lastValue = std::numeric_limits<double>::quiet_NaN();
    std::vector<glm::dvec3> bendPoints;  ///< where a rope lies on something, from end 0 to end 1, world
    /// Of a rope: the longest path that it allows. Infinite until its path is known.
    double ropeLength = std::numeric_limits<double>::infinity();
    double ropeSpeed = 0.0;  ///< m/s at which ropeLength changes in this step: a winch, or what was made too short
    glm::dvec3 force{0.0}, torque{0.0};  ///< N and N m on the second body, mean of the last step
    /// Joules that motors, winches, springs and soft rows gave the bodies in the last step: all that a joint may add.
    /// Infinite for a grab, as a hand may do any work.
    double work = 0.0;
};

/// A row of the Jacobian of a joint. Its velocity is
/// linearB . vB + angularB . wB - linearA . vA - angularA . wA.
struct JointRow {
    glm::dvec3 linearA{0.0}, angularA{0.0}, linearB{0.0}, angularB{0.0};

    /// The row's velocity Jv, m/s or rad/s.
    double velocity(const SolverState& A, const SolverState& B) const;
    /// Applies an impulse along the row to both bodies, N s or N m s.
    void apply(SolverState& A, SolverState& B, double impulse) const;
    /// 1 / (J M^-1 J^T); 0 if neither body can move along the row.
    double effectiveMass(const SolverState& A, const SolverState& B) const;
};

/// The axis along or about which a joint is free but for limits, spring, motor and friction.
struct FreeAxis {
    JointRow row;
    double value = 0.0;  ///< of the joint's coordinate: radians or metres
    /// The row together with the part of the locked rows that keeps these still: along it impulses act.
    JointRow push;
    std::array<double, 6> held{};  ///< that part of each locked row; all 0: what is locked is not considered
    double mass = 0.0;             ///< effective, along push
    double arc = 0.0;              ///< of a coordinate in metres: see addArcs(), m/s
};

/// A spring along a row with the effective mass m: its impulse becomes larger by
/// -m (pull x + massScale v) - impulseScale times itself, with the row's coordinate x and its velocity v.
struct AxisSpring {
    double pull = 0.0;  ///< 1/s
    double massScale = 0.0, impulseScale = 0.0;
};

/// A joint while it is solved.
struct JointRows {
    JointConstraint* c = nullptr;
    int rows = 0;  ///< that are locked
    std::array<JointRow, 6> row;
    std::array<double, 6> error{};                 ///< of position, by row
    std::array<double, 6> speed{};                 ///< that a row shall have, m/s or rad/s
    std::array<double, 6> arc{};                   ///< see addArcs(), m/s or rad/s
    std::array<std::array<double, 6>, 6> lower{};  ///< L of the L D L^T of J M^-1 J^T
    std::array<double, 6> diagonal{};              ///< D; 0: nothing can move along the row
    double errorRate = 0.0;                        ///< 1/s, share of the locked rows' errors that is corrected
    Softness<double> limit;
    AxisSpring spring, lockedSpring;  ///< of the free axis, and of soft locked rows
    FreeAxis freeAxis;
    double servoSpeed = 0.0;           ///< m/s or rad/s that a position motor wants in this substep
    double servoLimit = 0.0;           ///< N s or N m s that it may give
    FreeAxis motorAxis;                ///< the free axis; of a wheel its spin, where the free axis is its suspension
    glm::dmat3 ballFrictionMass{0.0};  ///< effective mass of a ball's rotation
    bool isInSystem = false;           ///< its locked rows are solved by JointSystem
    bool isSoft = false;               ///< the locked rows, or a rope's limit, are a spring
    bool hasSpring = false;            ///< on the free axis
    bool hasServo = false;             ///< a position motor without a spring
    bool hasBallFriction = false;

    /// The state of the joint's first body.
    template <class State>
    State& stateA(std::span<State> states) const {
        return states[size_t(c->bodies[0])];
    }
    /// The state of the joint's second body.
    template <class State>
    State& stateB(std::span<State> states) const {
        return states[size_t(c->bodies[1])];
    }
};

/// Whether the free coordinate is limited above only: the angle of a cone or ball, the length of a rope.
inline bool hasOnlyUpperLimit(const Joint& joint) {
    return joint.kind == JointKind::Rope || joint.kind == JointKind::Cone ||
           (joint.kind == JointKind::Ball && joint.limits.on);
}

/// Computes rows, errors and the free axes where the bodies are now.
void computeRows(JointRows& rows, std::span<const SolverBody> bodies);
/// Sets by how much faster than at their velocities of now the locked rows and free ways in metres change in a substep
/// of this length: bodies that turn move their ends along arcs, and velocities along the chords' tangents. Without
/// that, errors of position would have to grow until their correction does it, in the direction of some substeps ago: a
/// drag on all that turns about a point. Needs computeRows(). isFast: free rotation changes the axis noticeably.
void addArcs(JointRows& rows, std::span<const SolverBody> bodies, std::span<const SolverState> states, double seconds,
             bool isFast);
/// Factorizes J M^-1 J^T of the joint's own locked rows into lower and diagonal.
void factorize(JointRows& rows, const SolverState& A, const SolverState& B);
/// Replaces x, a change of velocity of the first `count` locked rows, by the impulses that make it. Needs factorize().
void solveBlock(const JointRows& rows, std::array<double, 6>& x, int count);
/// Sets push and mass of the free axes. A load beside its axis turns if it is pushed along the axis alone: what is
/// locked would have to stop that, iteration after iteration.
void projectFreeAxes(JointRows& rows, const SolverState& A, const SolverState& B);
/// The change of velocity that a locked row needs. useBias: errors of position are corrected too.
double velocityError(const JointRows& rows, int row, const SolverState& A, const SolverState& B, bool useBias);

}  // namespace rubble
