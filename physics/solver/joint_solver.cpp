#include "physics/solver/joint_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/bodies/limits.h"
#include "physics/math/clamp_length.h"
#include "runtime/core/constants.h"

// Joints by sequential impulses, with a direct solver for what is rigid.
//
// A joint takes degrees of freedom away from two bodies. Each is a row of its Jacobian J with a position error C and
// the velocity Jv = dC/dt (rows after Catto, "Modeling and Solving Constraints", GDC 2009). An impulse x along the row
// changes Jv by x / m, with the effective mass m = 1 / (J M^-1 J^T). So x = -m (Jv + bias), where the bias takes out
// a part of C: kErrorReduction / h for rigid rows (Baumgarte, 1972), or a spring (soft_constraint.h).
//   * Locked rows of rigid joints: all of them at once (JointSystem). Of joints that are soft or have a largest force:
//     each joint by itself, its up to six rows at once by L D L^T, and the sum clamped.
//   * The free axis: spring, motor, friction and limits, one after the other, each with its own accumulated impulse and
//     its bounds. A limit is an inequality, as a contact is: its impulse is clamped at 0. A position motor is a servo:
//     it wants the velocity that a damped spring without any load would have, so what it bears does not bend it.
//   * A rope is a limit on the length of its path, which a winch moves: what hangs on it gets the winch's speed.
// Iterations go through the joints forward and back, so that a load on one end of a chain arrives at the other. After
// the bodies have moved, the same without bias removes the velocity that corrected positions.

namespace rubble {
namespace {

constexpr double kErrorReduction = 0.2;  ///< of a rigid row's error, in a substep
constexpr double kServoHertz = 2.0;      ///< of the critically damped motion of a position motor without a spring
constexpr double kMaxSymplectic = 0.25;  ///< (omega h)^2 of the slow springs: sixteen on one body are stable, too
/// m/s2 or rad/s2 that a position motor without a largest force may give what it moves, besides what its way to the
/// target needs. Against something that does not give, its impulse would grow for ever.
constexpr double kMaxServoAcceleration = 1000.0;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
/// Radians in a substep: from which bodies move their joints' ends along arcs; from which these are found twice, as
/// impulses change them; and up to which.
constexpr double kMinTurn = 0.01, kFastTurn = 0.03, kMaxTurn = 1.2;
constexpr double kBraking = 0.7;           ///< share of a hand's force or torque with which it begins to brake
constexpr double kRopeStretchForce = 1e4;  ///< N under which a rope stretches by its `stretch`
/// Iterations over joints in a substep: without a system, and with one that has the rigid rows.
constexpr int kIterations = 4, kIterationsWithSystem = 2;

/// Whether a joint's spring acts on its free axis. The springs of other kinds soften the locked rows.
bool hasFreeAxisSpring(const Joint& joint) {
    return joint.kind == JointKind::Hinge || joint.kind == JointKind::Prismatic || joint.kind == JointKind::Wheel;
}

/// Whether a joint's locked rows are a spring, as those of a hand. They see their errors, and need no arcs.
bool hasSoftRows(const Joint& joint) {
    return joint.spring.hertz > 0.0 && !hasFreeAxisSpring(joint);
}

double withinHalfTurn(double angle) {
    return angle > kPi ? angle - 2.0 * kPi : angle < -kPi ? angle + 2.0 * kPi : angle;
}

bool hasPositionMotor(const Joint& joint) {
    return joint.motor.mode == MotorMode::Position && joint.kind != JointKind::Wheel;
}

/// The speed that a motor wants, m/s or rad/s: no faster than bodies may be. Beyond, it would give what carries it ever
/// more, while what it drives is clamped.
double motorSpeed(const Joint& joint) {
    const double most = joint.kind == JointKind::Prismatic ? limits::kMaxSpeed : limits::kMaxAngularSpeed;
    return std::clamp(joint.motor.target, -most, most);
}

/// From -h k x - (h d + theta h^2 k) v, with the velocity v after the impulse. theta is 0 for slow springs: then the
/// substep is symplectic, and a spring without damping has none. It grows to 1, implicit Euler, for those that would
/// need shorter substeps.
AxisSpring makeSpring(const JointSpring& spring, double seconds) {
    const double turn = kSoftTwoPi * spring.hertz * seconds,
                 theta = std::max(0.0, 1.0 - kMaxSymplectic / (turn * turn)),
                 softness = turn * (2.0 * spring.dampingRatio + theta * turn), scale = 1.0 / (1.0 + softness);
    return {turn * turn / seconds * scale, softness * scale, scale};
}

/// How far the free coordinate is from the target of a position motor, or from 0; the shorter way round for a hinge.
double targetError(const JointRows& e) {
    const Joint& joint = *e.c->joint;
    const double error = e.freeAxis.value - (hasPositionMotor(joint) ? joint.motor.target : 0.0);
    return joint.kind == JointKind::Hinge ? withinHalfTurn(error) : error;
}

/// Adds to an accumulated impulse within bounds, and calls apply with what was added.
template <class F>
void addClamped(double& sum, double impulse, double low, double high, F&& apply) {
    const double before = sum;
    sum = std::max(low, std::min(before + impulse, high));
    apply(sum - before);
}
template <class F>
void addClamped(double& sum, double impulse, double bound, F&& apply) {
    addClamped(sum, impulse, -bound, bound, apply);
}

/// The length of a rope's path that its winch allows, so many seconds before the end of the substep.
double ropeLimit(const JointConstraint& c, double seconds) {
    return c.ropeLength - c.ropeSpeed * seconds;
}

glm::dmat3 inverseOf(const glm::dmat3& k) {
    return glm::determinant(k) > 0.0 ? glm::inverse(k) : glm::dmat3(0.0);
}

}  // namespace

/// Applies an impulse along a free axis, with what keeps the locked rows still.
void JointSolver::applyAlong(JointRows& e, const FreeAxis& axis, SolverState& A, SolverState& B, double impulse) {
    axis.push.apply(A, B, impulse);
    for (size_t r = 0; r < size_t(e.rows); ++r) e.c->lockedImpulse[r] -= axis.held[r] * impulse;
}

void JointSolver::begin(std::span<JointConstraint* const> joints, std::span<SolverState> states) {
    m_joints.clear();
    m_isNew = true;
    if (!joints.empty()) m_stiffness.begin(states.size());
    for (JointConstraint* c : joints) {
        JointRows& e = m_joints.emplace_back();
        e.c = c;
        e.isInSystem = !c->constraint && c->joint->kind != JointKind::Rope && c->joint->maxForce == 0.0 &&
                       c->joint->maxTorque == 0.0 && !hasSoftRows(*c->joint);
        c->force = c->torque = glm::dvec3(0.0);
        c->work = c->joint->hand ? kNoLimit : 0.0;
        for (const int body : c->bodies) states[size_t(body)].isConstrained = states[size_t(body)].isJointed = true;
    }
}

void JointSolver::prepare(std::span<const SolverBody> bodies, std::span<SolverState> states, const glm::dvec3& fall,
                          double seconds) {
    m_seconds = seconds;
    m_halfFall = 0.5 * fall;
    m_stiffness.apply(m_joints, bodies, states, seconds);
    for (JointRows& e : m_joints) {
        computeRows(e, bodies);
        e.arc = {};
        e.freeAxis.arc = 0.0;
        e.c->ropeLength += e.c->ropeSpeed * seconds;
    }
    followArcs(bodies, states, kMinTurn, kMaxTurn);
    if (m_isNew) m_system.build(m_joints);
    m_isNew = false;
    m_system.factorize(m_joints, states);
    for (JointRows& e : m_joints) {
        SolverState &A = e.stateA(states), &B = e.stateB(states);
        if (isSolvedAlone(e)) factorize(e, A, B);
        projectFreeAxes(e, A, B);
        prepareJoint(e, A, B);
        if (e.hasServo) prepareServo(e, A, B);
    }
    m_work.begin(m_joints, states, m_halfFall, true);
    for (JointRows& e : m_joints) warmStart(e, e.stateA(states), e.stateB(states));
}

void JointSolver::followMove(std::span<const SolverBody> bodies, std::span<SolverState> states) {
    m_work.end(m_joints, states);
    for (JointRows& e : m_joints) {  // velocities must be right along the rows of now
        const SolverState &A = e.stateA(states), &B = e.stateB(states);
        computeRows(e, bodies);
        projectFreeAxes(e, A, B);
        if (isSolvedAlone(e)) factorize(e, A, B);
    }
    m_system.factorize(m_joints, states);
    m_work.begin(m_joints, states, -m_halfFall, false);
}

/// Of joints of bodies, and of ropes, that turn by this, in radians a substep. Wheels are held in their middle. What
/// turns faster loses speed, as far as its joints are not in its middle.
void JointSolver::followArcs(std::span<const SolverBody> bodies, std::span<const SolverState> states, double minTurn,
                             double maxTurn) {
    for (JointRows& e : m_joints) {
        const Joint& joint = *e.c->joint;
        if (e.c->constraint || joint.drives || hasSoftRows(joint) || joint.kind == JointKind::Wheel) continue;
        const SolverState &A = e.stateA(states), &B = e.stateB(states);
        double spin = double(std::max(glm::length(A.w), glm::length(B.w)));
        if (joint.kind == JointKind::Rope)
            spin = std::max(spin, double(glm::length(B.v - A.v)) / std::max(e.freeAxis.value, 0.01));
        const double turn = spin * m_seconds;
        if (turn > minTurn && turn < maxTurn) addArcs(e, bodies, states, m_seconds, turn > kFastTurn);
    }
}

/// Softness and effective masses.
void JointSolver::prepareJoint(JointRows& e, SolverState& A, SolverState& B) const {
    const Joint& joint = *e.c->joint;
    e.isSoft = hasSoftRows(joint);
    e.limit = {kErrorReduction / m_seconds, 1.0, 0.0};
    e.errorRate = e.limit.biasRate;
    if (e.isSoft) e.lockedSpring = makeSpring(joint.spring, m_seconds);
    if (e.isSoft && joint.hand) brakeInTime(e, A);
    prepareFreeAxis(e);
    e.hasBallFriction = joint.friction > 0.0 && (joint.kind == JointKind::Ball || joint.kind == JointKind::Cone);
    dropImpulsesOfWhatIsOff(e);
    if (e.hasBallFriction) {
        const glm::dmat3 k = glm::dmat3(A.inverseInertia) + glm::dmat3(B.inverseInertia);
        e.ballFrictionMass = inverseOf(k);
    }
}

/// What has been switched off since the last step is not warm started. A motor of another mode goes on with its
/// impulse, or what it pushes against would push alone.
void JointSolver::dropImpulsesOfWhatIsOff(JointRows& e) {
    JointConstraint& c = *e.c;
    const Joint& joint = *c.joint;
    const bool isDriven = joint.motor.mode == MotorMode::Speed, isPulled = e.hasSpring || e.hasServo;
    if (isDriven && !isPulled) c.motorImpulse += c.springImpulse;
    if (!isDriven && e.hasServo) c.springImpulse += c.motorImpulse;
    if (!isPulled) c.springImpulse = 0.0;
    if (!isDriven) c.motorImpulse = 0.0;
    if (joint.friction <= 0.0 || e.hasBallFriction) c.frictionImpulse = 0.0;
    if (!e.hasBallFriction) c.ballFriction = glm::dvec3(0.0);
}

void JointSolver::prepareFreeAxis(JointRows& e) const {
    const Joint& joint = *e.c->joint;
    e.hasSpring = hasFreeAxisSpring(joint) && joint.spring.hertz > 0.0;
    if (e.hasSpring) e.spring = makeSpring(joint.spring, m_seconds);
    e.hasServo = !e.hasSpring && hasFreeAxisSpring(joint) && hasPositionMotor(joint);
    if (joint.kind == JointKind::Rope) {
        e.isSoft = joint.rope.stretch > 0.0 && e.freeAxis.mass > 0.0;
        const double stiffness = e.isSoft ? kRopeStretchForce / (joint.rope.stretch * joint.rope.length) : 0.0;
        if (e.isSoft) e.limit = makeSoft<double>(std::sqrt(stiffness / e.freeAxis.mass) / kSoftTwoPi, 1.0, m_seconds);
    }
}

/// The implicit step of a damped spring from the velocity of the last substep: that of now has gravity in it already.
void JointSolver::prepareServo(JointRows& e, const SolverState& A, const SolverState& B) const {
    JointConstraint& c = *e.c;
    const double moved = e.freeAxis.value - c.lastValue,
                 way = c.joint->kind == JointKind::Hinge ? withinHalfTurn(moved) : moved,
                 speed = std::isnan(way) ? e.freeAxis.row.velocity(A, B) : way / m_seconds;
    const double turn = kSoftTwoPi * kServoHertz * m_seconds, error = targetError(e);
    c.lastValue = e.freeAxis.value;
    e.servoSpeed = (speed - turn * turn * error / m_seconds) / (1.0 + 2.0 * turn + turn * turn);
    e.servoLimit =
        c.joint->motor.maxForce > 0.0
            ? c.joint->motor.maxForce * m_seconds
            : e.freeAxis.mass * (kMaxServoAcceleration * m_seconds + turn * turn * std::abs(error) / m_seconds);
}

void JointSolver::warmStart(const JointRows& e, SolverState& A, SolverState& B) {
    const JointConstraint& c = *e.c;
    for (size_t i = 0; i < size_t(e.rows); ++i) e.row[i].apply(A, B, c.lockedImpulse[i]);
    e.freeAxis.row.apply(A, B, c.limitImpulse[0] - c.limitImpulse[1] + c.springImpulse);
    e.motorAxis.row.apply(A, B, c.motorImpulse + c.frictionImpulse);
    if (e.hasBallFriction) JointRow{{}, c.ballFriction, {}, c.ballFriction}.apply(A, B, 1.0);
}

void JointSolver::solve(std::span<const SolverBody> bodies, std::span<SolverState> states, bool useBias) {
    const auto solveJoint = [&](JointRows& e) {
        SolverState &A = e.stateA(states), &B = e.stateB(states);
        solveFreeAxis(e, A, B, useBias);
        if (e.hasBallFriction) solveBallFriction(e, A, B);
        if (isSolvedAlone(e)) solveLockedRows(e, A, B, useBias);
    };
    const int iterations = m_system.empty() ? kIterations : kIterationsWithSystem;
    for (int i = 0; i < iterations; ++i) {
        if (useBias && i == 1) followArcs(bodies, states, kFastTurn, 0.5 * kMaxTurn);
        if (i % 2 == 0)
            for (JointRows& e : m_joints) solveJoint(e);
        else
            for (size_t k = m_joints.size(); k-- > 0;) solveJoint(m_joints[k]);
        m_system.solve(m_joints, states, useBias);
    }
}

void JointSolver::solveImpact(std::span<const SolverBody> bodies, std::span<SolverState> states) {
    m_saved.clear();
    for (const JointRows& e : m_joints) {
        const JointConstraint& c = *e.c;
        m_saved.push_back(
            {c.lockedImpulse, c.limitImpulse, c.springImpulse, c.motorImpulse, c.frictionImpulse, c.ballFriction});
    }
    m_impactWork.begin(m_joints, states, m_work.early(), false);
    solve(bodies, states, false);
    m_impactWork.end(m_joints, states);
    for (size_t i = 0; i < m_joints.size(); ++i) {
        JointConstraint& c = *m_joints[i].c;
        const Impulses& saved = m_saved[i];
        c.lockedImpulse = saved.locked, c.limitImpulse = saved.limit;
        c.springImpulse = saved.spring, c.motorImpulse = saved.motor, c.frictionImpulse = saved.friction;
        c.ballFriction = saved.ballFriction;
    }
}

/// What holds the velocity along one row, as a motor does, but with a least and a largest force.
void JointSolver::solveConstraint(JointRows& e, SolverState& A, SolverState& B) const {
    JointConstraint& c = *e.c;
    const BodyConstraint& held = *c.constraint;
    const bool isLimited = held.minForce != 0.0 || held.maxForce != 0.0;
    const double low = isLimited ? held.minForce * m_seconds : -kNoLimit,
                 high = isLimited ? held.maxForce * m_seconds : kNoLimit;
    addClamped(c.motorImpulse, e.motorAxis.mass * (held.speed - e.motorAxis.row.velocity(A, B)), low, high,
               [&](double impulse) { applyAlong(e, e.motorAxis, A, B, impulse); });
}

/// Spring, motor, friction and limits.
void JointSolver::solveFreeAxis(JointRows& e, SolverState& A, SolverState& B, bool useBias) const {
    JointConstraint& c = *e.c;
    if (c.constraint) return solveConstraint(e, A, B);
    const Joint& joint = *c.joint;
    const FreeAxis& axis = e.motorAxis;
    if (e.hasSpring && useBias) solveSpring(e, A, B);
    if (e.hasServo)
        addClamped(c.springImpulse, e.freeAxis.mass * (e.servoSpeed - e.freeAxis.row.velocity(A, B)), e.servoLimit,
                   [&](double impulse) { applyAlong(e, e.freeAxis, A, B, impulse); });
    if (joint.motor.mode == MotorMode::Speed) {
        const double speed = axis.row.velocity(A, B) - motorSpeed(joint);
        addClamped(c.motorImpulse, -axis.mass * speed, joint.motor.maxForce * m_seconds,
                   [&](double impulse) { applyAlong(e, axis, A, B, impulse); });
    }
    if (joint.friction > 0.0 && !e.hasBallFriction)
        addClamped(c.frictionImpulse, -axis.mass * axis.row.velocity(A, B), joint.friction * m_seconds,
                   [&](double impulse) { applyAlong(e, axis, A, B, impulse); });
    if (!joint.limits.on && !hasOnlyUpperLimit(joint)) return;
    if (e.isSoft && joint.kind == JointKind::Rope && !useBias) return;
    if (!hasOnlyUpperLimit(joint)) solveLimit(e, A, B, false, useBias);
    solveLimit(e, A, B, true, useBias);
}

/// The spring pulls the free coordinate to 0, or to the target of a position motor.
void JointSolver::solveSpring(JointRows& e, SolverState& A, SolverState& B) const {
    JointConstraint& c = *e.c;
    const JointMotor& motor = c.joint->motor;
    const double maxImpulse =
        hasPositionMotor(*c.joint) && motor.maxForce > 0.0 ? motor.maxForce * m_seconds : kNoLimit;
    const double change = e.spring.pull * targetError(e) + e.spring.massScale * e.freeAxis.row.velocity(A, B);
    const double impulse = -e.freeAxis.mass * change - e.spring.impulseScale * c.springImpulse;
    addClamped(c.springImpulse, impulse, maxImpulse, [&](double added) { applyAlong(e, e.freeAxis, A, B, added); });
}

/// One limit of the free coordinate. Short of the limit, the coordinate may move up to it within the substep (as a
/// speculative contact); beyond, it is pushed back.
void JointSolver::solveLimit(JointRows& e, SolverState& A, SolverState& B, bool isHigh, bool useBias) const {
    const Joint& joint = *e.c->joint;
    const double high = joint.kind == JointKind::Rope ? ropeLimit(*e.c, useBias ? m_seconds : 0.0) : joint.limits.high;
    const double distance = isHigh ? high - e.freeAxis.value : e.freeAxis.value - joint.limits.low;
    const double sign = isHigh ? -1.0 : 1.0;
    double bias = 0.0, massScale = 1.0, impulseScale = 0.0;
    if (distance > 0.0)
        bias = distance / m_seconds;
    else if (useBias) {
        bias = std::max(e.limit.biasRate * distance, -kMaxCorrectionSpeed);
        massScale = e.limit.massScale;
        impulseScale = e.limit.impulseScale;
    }
    double& impulse = e.c->limitImpulse[isHigh ? 1 : 0];
    const double arc = useBias ? e.freeAxis.arc : 0.0;
    const double before = impulse, speed = sign * (e.freeAxis.row.velocity(A, B) + arc - e.c->ropeSpeed);
    impulse = std::max(before - e.freeAxis.mass * massScale * (speed + bias) - impulseScale * before, 0.0);
    if (e.isSoft && distance > 0.0) impulse = 0.0;  // a spring that is not stretched
    applyAlong(e, e.freeAxis, A, B, sign * (impulse - before));
}

/// Friction against the relative rotation of a ball about any axis; the impulse is clamped by its length.
void JointSolver::solveBallFriction(JointRows& e, SolverState& A, SolverState& B) const {
    JointConstraint& c = *e.c;
    const glm::dvec3 before = c.ballFriction;
    c.ballFriction = clampedLength(before - e.ballFrictionMass * glm::dvec3(B.w - A.w), c.joint->friction * m_seconds);
    const glm::dvec3 change = c.ballFriction - before;
    JointRow{{}, change, {}, change}.apply(A, B, 1.0);
}

/// The rows of a hand see no more of their errors than they can brake from. A critically damped spring of w rad/s pulls
/// by its error C until v = w C / 2; from there on it brakes. With the acceleration a, at most, it must brake from
/// v^2 = 2 a C.
void JointSolver::brakeInTime(JointRows& e, const SolverState& A) const {
    const Joint& joint = *e.c->joint;
    const auto limit = [&](size_t first, auto&& acceleration) {
        const glm::dvec3 error(e.error[first], e.error[first + 1], e.error[first + 2]);
        const double length = glm::length(error);
        if (!(length > 0.0)) return;
        const double seen =
            std::sqrt(8.0 * kBraking * acceleration(error / length) * length) / (kSoftTwoPi * joint.spring.hertz);
        for (size_t i = first; seen < length && i < first + 3; ++i) e.error[i] *= seen / length;
    };
    if (joint.maxForce > 0.0) {
        const double most = joint.maxForce * double(A.inverseMass);
        const glm::dvec3 gravity = m_halfFall * (2.0 * double(A.gravityScale) / m_seconds);
        limit(0, [&](const glm::dvec3& n) { return std::max(most - glm::dot(gravity, n), 0.1 * most); });
    }
    if (joint.maxTorque > 0.0 && e.rows == 6)
        limit(3, [&](const glm::dvec3& n) {  // with the point held: n . S n, S the factored rows' last block
            double perTorque = 0.0;
            for (size_t j = 3; j < 6; ++j) {
                double along = n[int(j) - 3];
                for (size_t i = j + 1; i < 6; ++i) along += e.lower[i][j] * n[int(i) - 3];
                perTorque += e.diagonal[j] * along * along;
            }
            return joint.maxTorque * perTorque;
        });
}

/// Gives three locked rows this sum of impulses, or as much of it as `most`.
void JointSolver::setLocked(JointRows& e, SolverState& A, SolverState& B, size_t first, glm::dvec3 impulse,
                            double most) const {
    impulse = clampedLength(impulse, most);
    for (size_t i = 0; i < 3; ++i) {
        double& sum = e.c->lockedImpulse[first + i];
        e.row[first + i].apply(A, B, impulse[int(i)] - sum);
        sum = impulse[int(i)];
    }
}

/// Where point or rotation needs more than its largest force or torque, the other is solved once more with what there
/// is: else it would resist what does not come.
void JointSolver::solveLockedRows(JointRows& e, SolverState& A, SolverState& B, bool useBias) const {
    if (e.isSoft && !useBias) return;
    JointConstraint& c = *e.c;
    std::array<double, 6> x{};
    const auto want = [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i)
            x[i] = e.isSoft ? -(e.lockedSpring.pull * e.error[i] + e.lockedSpring.massScale * e.row[i].velocity(A, B))
                            : velocityError(e, int(i), A, B, useBias);
    };
    const auto sumOf = [&](size_t i) {
        return x[i] + (e.isSoft ? 1.0 - e.lockedSpring.impulseScale : 1.0) * c.lockedImpulse[i];
    };
    const auto sumsFrom = [&](size_t first) { return glm::dvec3(sumOf(first), sumOf(first + 1), sumOf(first + 2)); };
    want(0, size_t(e.rows));
    solveBlock(e, x, e.rows);
    const auto largest = [&](double force) { return force > 0.0 ? force * m_seconds : kNoLimit; };
    const double maxPull = largest(c.joint->maxForce), maxTurn = largest(c.joint->maxTorque);
    const bool pullsAll = e.rows >= 3 && glm::length(sumsFrom(0)) > maxPull,
               turnsAll = e.rows == 6 && glm::length(sumsFrom(3)) > maxTurn;
    if (!pullsAll && !turnsAll) {
        for (size_t i = 0; i < size_t(e.rows); ++i) {
            const double sum = sumOf(i);
            e.row[i].apply(A, B, sum - c.lockedImpulse[i]);
            c.lockedImpulse[i] = sum;
        }
    } else if (pullsAll) {
        setLocked(e, A, B, 0, sumsFrom(0), maxPull);
        if (e.rows < 6) return;
        want(3, 6);
        const glm::dvec3 turn =
            inverseOf(glm::dmat3(A.inverseInertia) + glm::dmat3(B.inverseInertia)) * glm::dvec3(x[3], x[4], x[5]);
        for (size_t i = 3; i < 6; ++i) x[i] = turn[int(i) - 3];
        setLocked(e, A, B, 3, sumsFrom(3), maxTurn);
    } else {
        setLocked(e, A, B, 3, sumsFrom(3), maxTurn);
        want(0, 3);
        solveBlock(e, x, 3);
        setLocked(e, A, B, 0, sumsFrom(0), maxPull);
    }
}

void JointSolver::endSubstep(std::span<const SolverState> states, double stepSeconds) {
    m_work.end(m_joints, states);
    for (JointRows& e : m_joints) {
        JointConstraint& c = *e.c;
        const auto add = [&](const JointRow& row, double impulse) {
            const bool isRotation = row.linearB == glm::dvec3(0.0);
            (isRotation ? c.torque : c.force) += (isRotation ? row.angularB : row.linearB) * (impulse / stepSeconds);
        };
        for (size_t i = 0; i < size_t(e.rows); ++i) add(e.row[i], c.lockedImpulse[i]);
        add(e.freeAxis.row, c.limitImpulse[0] - c.limitImpulse[1] + c.springImpulse);
        add(e.motorAxis.row, c.motorImpulse + c.frictionImpulse);
        if (e.hasBallFriction) c.torque += c.ballFriction / stepSeconds;
        if (c.ropeSpeed < 0.0 && !e.isSoft) c.work -= c.limitImpulse[1] * c.ropeSpeed;  // a winch winds
    }
}

}  // namespace rubble
