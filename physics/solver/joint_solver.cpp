#include "physics/solver/joint_solver.h"

#include <algorithm>
#include <cmath>

#include "physics/math/angles.h"

namespace rubble {
namespace {

constexpr double kErrorReduction = 0.2;       ///< share of an error that a substep works off
constexpr double kMotorHertz = 2.0;           ///< of a motor that goes to a position, if the joint has no spring
constexpr double kStretchForce = 1e4;         ///< N under which a rope isSoft its `stretch`
constexpr double kMaxCorrectionSpeed = 10.0;  ///< m/s or rad/s at which errors are worked off

glm::dvec3 xOf(const Pose& pose) {
    return pose.rotation * glm::dvec3(1.0, 0.0, 0.0);
}
glm::dvec3 yOf(const Pose& pose) {
    return pose.rotation * glm::dvec3(0.0, 1.0, 0.0);
}
glm::dvec3 zOf(const Pose& pose) {
    return pose.rotation * glm::dvec3(0.0, 0.0, 1.0);
}

bool hasFreeAxisSpring(const Joint& joint) {
    return joint.kind == JointKind::Hinge || joint.kind == JointKind::Prismatic || joint.kind == JointKind::Wheel;
}

double clampMagnitude(double value, double most) {
    return std::max(-most, std::min(value, most));
}

glm::dvec3 shortened(const glm::dvec3& v, double most) {
    const double length2 = glm::dot(v, v);
    return length2 > most * most ? v * (most / std::sqrt(length2)) : v;
}

}  // namespace

JointSolver::Softness JointSolver::makeSoft(double hertz, double dampingRatio, double seconds) {
    const double omega = 2.0 * 3.14159265358979 * hertz;
    const double a1 = 2.0 * dampingRatio + seconds * omega, a2 = seconds * omega * a1, a3 = 1.0 / (1.0 + a2);
    return {omega / a1, a2 * a3, a3};
}

double JointSolver::rowVelocity(const Row& row, const SolverState& A, const SolverState& B) {
    return glm::dot(row.linearB, glm::dvec3(B.v)) + glm::dot(row.angularB, glm::dvec3(B.w)) -
           glm::dot(row.linearA, glm::dvec3(A.v)) - glm::dot(row.angularA, glm::dvec3(A.w));
}

void JointSolver::push(const Row& row, SolverState& A, SolverState& B, double impulse) {
    A.v -= glm::vec3(row.linearA * (impulse * A.inverseMass));
    A.w -= A.inverseInertia * glm::vec3(row.angularA * impulse);
    B.v += glm::vec3(row.linearB * (impulse * B.inverseMass));
    B.w += B.inverseInertia * glm::vec3(row.angularB * impulse);
}

double JointSolver::effectiveMass(const Row& row, const SolverState& A, const SolverState& B) {
    const double k = double(A.inverseMass) * glm::dot(row.linearA, row.linearA) +
                     double(B.inverseMass) * glm::dot(row.linearB, row.linearB) +
                     glm::dot(row.angularA, glm::dmat3(A.inverseInertia) * row.angularA) +
                     glm::dot(row.angularB, glm::dmat3(B.inverseInertia) * row.angularB);
    return k > 0.0 ? 1.0 / k : 0.0;
}

void JointSolver::begin(std::span<JointConstraint* const> joints, std::span<SolverState> states) {
    m_joints.clear();
    m_isNew = true;
    for (JointConstraint* c : joints) {
        Entry& e = m_joints.emplace_back();
        e.c = c;
        e.isInSystem = c->joint->kind != JointKind::Rope && c->joint->maxForce == 0.0 &&
                       (c->joint->spring.hertz == 0.0 || hasFreeAxisSpring(*c->joint));
        c->force = c->torque = glm::dvec3(0.0);
        for (const int body : c->bodies) states[size_t(body)].isConstrained = states[size_t(body)].isJointed = true;
    }
}

/// Where the joint's ends are, how far they are from where they should be, and which displacement that can be mended.
void JointSolver::computeRows(Entry& e, std::span<const SolverBody> bodies) const {
    const Joint& joint = *e.c->joint;
    std::array<Pose, 2> at;
    std::array<glm::dvec3, 2> arm;
    for (size_t i = 0; i < 2; ++i) {
        const SolverBody& body = bodies[size_t(e.c->bodies[i])];
        at[i] = Pose{body.position, body.rotation} * e.c->frames[i];
        arm[i] = at[i].position - body.position;
    }
    const glm::dvec3 apart = at[1].position - at[0].position, x = xOf(at[0]), y = yOf(at[0]), z = zOf(at[0]);
    e.rows = 0;
    const auto slideRow = [&](const glm::dvec3& displacement) {
        return Row{displacement, glm::cross(arm[0] + apart, displacement), displacement,
                   glm::cross(arm[1], displacement)};
    };
    const auto hold = [&](const Row& row, double error) {
        e.error[size_t(e.rows)] = error;
        e.row[size_t(e.rows++)] = row;
    };
    const auto holdPoint = [&] {
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 displacement(0.0);
            displacement[i] = 1.0;
            hold({displacement, glm::cross(arm[0], displacement), displacement, glm::cross(arm[1], displacement)},
                 apart[i]);
        }
    };
    const auto holdAxis = [&](const glm::dvec3& axis, const glm::dvec3& side1, const glm::dvec3& side2) {
        const glm::dvec3 tilt = glm::cross(axis, xOf(at[1]));
        hold({{}, side1, {}, side1}, glm::dot(tilt, side1));
        hold({{}, side2, {}, side2}, glm::dot(tilt, side2));
    };
    glm::dquat relativeRotation = glm::conjugate(at[0].rotation) * at[1].rotation;
    if (relativeRotation.w < 0.0) relativeRotation = -relativeRotation;
    const auto holdTurn = [&] {
        const glm::dvec3 error =
            at[0].rotation * (2.0 * glm::dvec3(relativeRotation.x, relativeRotation.y, relativeRotation.z));
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 axis(0.0);
            axis[i] = 1.0;
            hold({{}, axis, {}, axis}, error[i]);
        }
    };
    switch (joint.kind) {
        case JointKind::Ball:
        case JointKind::Cone:
            holdPoint();
            if (hasOnlyUpperLimit(joint)) {
                const glm::dvec3 axis = glm::cross(x, xOf(at[1]));
                const double sine = glm::length(axis);
                const glm::dvec3 about = sine > 1e-9 ? axis / sine : glm::dvec3(0.0);
                e.freeAxis.row = {{}, about, {}, about};
                e.freeAxis.value = deterministicAtan2(sine, glm::dot(x, xOf(at[1])));
            }
            break;
        case JointKind::Hinge:
            holdPoint();
            holdAxis(x, y, z);
            e.freeAxis.row = {{}, x, {}, x};
            e.freeAxis.value = twistAboutX(relativeRotation);
            break;
        case JointKind::Fixed:
            holdPoint();
            holdTurn();
            break;
        case JointKind::Prismatic:
            hold(slideRow(y), glm::dot(apart, y));
            hold(slideRow(z), glm::dot(apart, z));
            holdTurn();
            e.freeAxis.row = slideRow(x);
            e.freeAxis.value = glm::dot(apart, x);
            break;
        case JointKind::Wheel: {
            hold(slideRow(x), glm::dot(apart, x));
            hold(slideRow(z), glm::dot(apart, z));
            double cosine, sine;
            deterministicCosSin(joint.steer, cosine, sine);
            const glm::dvec3 axle = x * cosine - z * sine;
            holdAxis(axle, y, glm::cross(axle, y));
            e.freeAxis.row = slideRow(y);
            e.freeAxis.value = glm::dot(apart, y);
            e.motorAxis.row = {{}, axle, {}, axle};
            break;
        }
        case JointKind::Rope: {  // the displacement from end to end over what it lies on
            const std::vector<glm::dvec3>& bendPoints = e.c->bendPoints;
            const glm::dvec3 first = at[0].position - (bendPoints.empty() ? at[1].position : bendPoints.front());
            const glm::dvec3 last = at[1].position - (bendPoints.empty() ? at[0].position : bendPoints.back());
            const double firstLength = glm::length(first), lastLength = glm::length(last);
            const glm::dvec3 pullA = firstLength > 1e-6 ? first / firstLength : glm::dvec3(0.0, 1.0, 0.0);
            const glm::dvec3 pullB = lastLength > 1e-6 ? last / lastLength : glm::dvec3(0.0, -1.0, 0.0);
            e.freeAxis.row = {-pullA, glm::cross(arm[0], -pullA), pullB, glm::cross(arm[1], pullB)};
            e.freeAxis.value = bendPoints.empty() ? firstLength : firstLength + lastLength;
            for (size_t i = 1; i < bendPoints.size(); ++i)
                e.freeAxis.value += glm::length(bendPoints[i] - bendPoints[i - 1]);
            break;
        }  // see rope_solver
    }
}

/// L D L^T of the mass matrix of what is lockedImpulse; a direction in which nothing can move is left out.
void JointSolver::factorize(Entry& e, const SolverState& A, const SolverState& B) {
    const double massA = double(A.inverseMass), massB = double(B.inverseMass);
    const glm::dmat3 inertiaA(A.inverseInertia), inertiaB(B.inverseInertia);
    double k[6][6];
    for (int j = 0; j < e.rows; ++j) {
        const Row& row = e.row[size_t(j)];
        const glm::dvec3 a = inertiaA * row.angularA, b = inertiaB * row.angularB;
        for (int i = j; i < e.rows; ++i) {
            const Row& other = e.row[size_t(i)];
            k[i][j] = massA * glm::dot(row.linearA, other.linearA) + massB * glm::dot(row.linearB, other.linearB) +
                      glm::dot(a, other.angularA) + glm::dot(b, other.angularB);
        }
    }
    for (int j = 0; j < e.rows; ++j) {
        double d = k[j][j];
        for (int m = 0; m < j; ++m)
            d -= e.lower[size_t(j)][size_t(m)] * e.lower[size_t(j)][size_t(m)] * e.diagonal[size_t(m)];
        const bool moves = d > 1e-12 * k[j][j] && d > 0.0;
        e.diagonal[size_t(j)] = moves ? d : 0.0;
        for (int i = j + 1; i < e.rows; ++i) {
            double l = k[i][j];
            for (int m = 0; m < j; ++m)
                l -= e.lower[size_t(i)][size_t(m)] * e.lower[size_t(j)][size_t(m)] * e.diagonal[size_t(m)];
            e.lower[size_t(i)][size_t(j)] = moves ? l / d : 0.0;
        }
    }
}

void JointSolver::solveBlock(const Entry& e, std::array<double, 6>& x) {
    for (int i = 0; i < e.rows; ++i)
        for (int m = 0; m < i; ++m) x[size_t(i)] -= e.lower[size_t(i)][size_t(m)] * x[size_t(m)];
    for (int i = 0; i < e.rows; ++i)
        x[size_t(i)] = e.diagonal[size_t(i)] > 0.0 ? x[size_t(i)] / e.diagonal[size_t(i)] : 0.0;
    for (int i = e.rows - 1; i >= 0; --i)
        for (int m = i + 1; m < e.rows; ++m) x[size_t(i)] -= e.lower[size_t(m)][size_t(i)] * x[size_t(m)];
}

void JointSolver::prepare(std::span<const SolverBody> bodies, std::span<SolverState> states, double seconds) {
    m_seconds = seconds;
    for (Entry& e : m_joints) computeRows(e, bodies);
    if (m_isNew) buildSystem();
    m_isNew = false;
    factorizeSystem(states);
    for (Entry& e : m_joints) {
        JointConstraint& c = *e.c;
        const Joint& joint = *c.joint;
        SolverState &A = states[size_t(c.bodies[0])], &B = states[size_t(c.bodies[1])];
        if (m_order.empty() || !e.isInSystem) factorize(e, A, B);
        const bool springIsOnFreeAxis = hasFreeAxisSpring(joint);
        e.isSoft = joint.spring.hertz > 0.0 && !springIsOnFreeAxis;
        e.stop = {kErrorReduction / seconds, 1.0, 0.0};
        e.soft = e.isSoft ? makeSoft(joint.spring.hertz, joint.spring.dampingRatio, seconds) : e.stop;
        const bool goesToPlace =
            joint.motor.mode == MotorMode::Position && springIsOnFreeAxis && joint.kind != JointKind::Wheel;
        e.springs = springIsOnFreeAxis && (joint.spring.hertz > 0.0 || goesToPlace);
        if (e.springs)
            e.spring = joint.spring.hertz > 0.0 ? makeSoft(joint.spring.hertz, joint.spring.dampingRatio, seconds)
                                                : makeSoft(kMotorHertz, 1.0, seconds);
        e.freeAxis.mass = effectiveMass(e.freeAxis.row, A, B);
        if (joint.kind == JointKind::Rope) {
            e.isSoft = joint.rope.stretch > 0.0;
            const double stiffness = e.isSoft ? kStretchForce / (joint.rope.stretch * joint.rope.length) : 0.0;
            if (e.isSoft)
                e.stop = makeSoft(std::sqrt(stiffness * e.freeAxis.mass) / (2.0 * 3.14159265358979), 1.0, seconds);
        }
        if (joint.kind == JointKind::Wheel)
            e.motorAxis.mass = effectiveMass(e.motorAxis.row, A, B);
        else
            e.motorAxis = e.freeAxis;
        e.hasBallFriction = joint.friction > 0.0 && (joint.kind == JointKind::Ball || joint.kind == JointKind::Cone);
        if (e.hasBallFriction) {
            const glm::dmat3 k = glm::dmat3(A.inverseInertia) + glm::dmat3(B.inverseInertia);
            const double size = glm::determinant(k);
            e.ballFrictionMass = size > 0.0 ? glm::inverse(k) : glm::dmat3(0.0);
        }
        for (int i = 0; i < e.rows; ++i) push(e.row[size_t(i)], A, B, c.lockedImpulse[size_t(i)]);
        push(e.freeAxis.row, A, B, c.limitImpulse[0] - c.limitImpulse[1] + c.spring);
        push(e.motorAxis.row, A, B, c.motor + c.friction);
        if (e.hasBallFriction) push({{}, c.ballFriction, {}, c.ballFriction}, A, B, 1.0);
    }
}

/// Spring, motor, friction and limits of what is free to move.
void JointSolver::solveFreeAxis(Entry& e, SolverState& A, SolverState& B, bool useBias) const {
    JointConstraint& c = *e.c;
    const Joint& joint = *c.joint;
    const auto add = [&](const Row& row, double& sum, double impulse, double low, double high) {
        const double before = sum;
        sum = std::max(low, std::min(before + impulse, high));
        push(row, A, B, sum - before);
    };
    if (e.springs && useBias) {
        const bool goesToPlace = joint.motor.mode == MotorMode::Position && joint.kind != JointKind::Wheel;
        double away = e.freeAxis.value - (goesToPlace ? joint.motor.target : 0.0);
        constexpr double kPi = 3.14159265358979323846;
        if (joint.kind == JointKind::Hinge)
            away = away > kPi ? away - 2.0 * kPi : away < -kPi ? away + 2.0 * kPi : away;
        const double most = goesToPlace && joint.motor.maxForce > 0.0 ? joint.motor.maxForce * m_seconds : 1e30;
        const double speed = rowVelocity(e.freeAxis.row, A, B) + e.spring.biasRate * away;
        add(e.freeAxis.row, c.spring, -e.freeAxis.mass * e.spring.massScale * speed - e.spring.impulseScale * c.spring,
            -most, most);
    }
    if (joint.motor.mode == MotorMode::Speed) {
        const double most = joint.motor.maxForce * m_seconds;
        add(e.motorAxis.row, c.motor, -e.motorAxis.mass * (rowVelocity(e.motorAxis.row, A, B) - joint.motor.target),
            -most, most);
    }
    if (joint.friction > 0.0 && !e.hasBallFriction) {
        const double most = joint.friction * m_seconds;
        add(e.motorAxis.row, c.friction, -e.motorAxis.mass * rowVelocity(e.motorAxis.row, A, B), -most, most);
    }
    if (!joint.limits.on && !hasOnlyUpperLimit(joint)) return;
    if (e.isSoft && joint.kind == JointKind::Rope && !useBias) return;
    const double high = joint.kind == JointKind::Rope ? joint.rope.length : joint.limits.high;
    for (size_t side = hasOnlyUpperLimit(joint) ? 1 : 0; side < 2; ++side) {
        const double room = side ? high - e.freeAxis.value : e.freeAxis.value - joint.limits.low,
                     sign = side ? -1.0 : 1.0;
        double bias = 0.0, massScale = 1.0, impulseScale = 0.0;
        if (room > 0.0)
            bias = room / m_seconds;
        else if (useBias) {
            bias = std::max(e.stop.biasRate * room, -kMaxCorrectionSpeed);
            massScale = e.stop.massScale;
            impulseScale = e.stop.impulseScale;
        }
        const double before = c.limitImpulse[side], speed = sign * rowVelocity(e.freeAxis.row, A, B);
        c.limitImpulse[side] =
            std::max(before - e.freeAxis.mass * massScale * (speed + bias) - impulseScale * before, 0.0);
        push(e.freeAxis.row, A, B, sign * (c.limitImpulse[side] - before));
    }
}

void JointSolver::solveBallFriction(Entry& e, SolverState& A, SolverState& B) const {
    JointConstraint& c = *e.c;
    const glm::dvec3 before = c.ballFriction;
    c.ballFriction = shortened(before - e.ballFrictionMass * glm::dvec3(B.w - A.w), c.joint->friction * m_seconds);
    const glm::dvec3 change = c.ballFriction - before;
    push({{}, change, {}, change}, A, B, 1.0);
}

double JointSolver::velocityError(const Entry& e, int row, const SolverState& A, const SolverState& B, bool useBias) {
    const double repair = useBias ? clampMagnitude(e.soft.biasRate * e.error[size_t(row)], kMaxCorrectionSpeed) : 0.0;
    return -rowVelocity(e.row[size_t(row)], A, B) - repair;
}

void JointSolver::solveLockedAxes(Entry& e, SolverState& A, SolverState& B, bool useBias) const {
    JointConstraint& c = *e.c;
    if (e.isSoft && !useBias) return;
    std::array<double, 6> x{};
    for (int i = 0; i < e.rows; ++i) x[size_t(i)] = velocityError(e, i, A, B, useBias);
    solveBlock(e, x);
    std::array<double, 6> sum = c.lockedImpulse;
    for (size_t i = 0; i < size_t(e.rows); ++i)
        sum[i] += useBias ? e.soft.massScale * x[i] - e.soft.impulseScale * c.lockedImpulse[i] : x[i];
    if (c.joint->maxForce > 0.0 && e.rows >= 3) {
        const glm::dvec3 pull = shortened({sum[0], sum[1], sum[2]}, c.joint->maxForce * m_seconds);
        sum[0] = pull.x, sum[1] = pull.y, sum[2] = pull.z;
    }
    for (size_t i = 0; i < size_t(e.rows); ++i) push(e.row[i], A, B, sum[i] - c.lockedImpulse[i]);
    c.lockedImpulse = sum;
}

void JointSolver::solve(std::span<const SolverBody> bodies, std::span<SolverState> states, bool useBias) {
    if (!useBias) {  // they have moved: velocities are to be right where they are now
        for (Entry& e : m_joints) {
            computeRows(e, bodies);
            if (m_order.empty() || !e.isInSystem)
                factorize(e, states[size_t(e.c->bodies[0])], states[size_t(e.c->bodies[1])]);
        }
        factorizeSystem(states);
    }
    const auto one = [&](Entry& e) {
        SolverState &A = states[size_t(e.c->bodies[0])], &B = states[size_t(e.c->bodies[1])];
        solveFreeAxis(e, A, B, useBias);
        if (e.hasBallFriction) solveBallFriction(e, A, B);
        if (m_order.empty() || !e.isInSystem) solveLockedAxes(e, A, B, useBias);
    };
    for (int pass = 0; pass < (m_order.empty() ? kPasses : kSystemPasses);
         ++pass) {  // to and fro: what pulls at one end of a chain is felt at the other
        if (pass % 2 == 0)
            for (Entry& e : m_joints) one(e);
        else
            for (size_t i = m_joints.size(); i-- > 0;) one(m_joints[i]);
        solveSystem(states, useBias);
    }
}

void JointSolver::note(double stepSeconds) {
    for (Entry& e : m_joints) {
        JointConstraint& c = *e.c;
        for (size_t i = 0; i < size_t(e.rows); ++i) {
            const bool isTurn = e.row[i].linearB == glm::dvec3(0.0);
            (isTurn ? c.torque : c.force) +=
                (isTurn ? e.row[i].angularB : e.row[i].linearB) * (c.lockedImpulse[i] / stepSeconds);
        }
        const double stopped = (c.limitImpulse[0] - c.limitImpulse[1]) / stepSeconds;
        c.force += e.freeAxis.row.linearB * stopped;
        if (e.freeAxis.row.linearB == glm::dvec3(0.0)) c.torque += e.freeAxis.row.angularB * stopped;
    }
}

}  // namespace rubble
