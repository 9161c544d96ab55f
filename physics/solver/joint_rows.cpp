#include "physics/solver/joint_rows.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/angles.h"

namespace rubble {
namespace {

/// Fills in the rows of one joint. The frames of its ends have their axis along x.
class RowBuilder {
public:
    RowBuilder(JointRows& rows, const SolverBody& first, const SolverBody& second)
        : m_rows(rows), m_joint(*rows.c->joint) {
        for (size_t i = 0; i < 2; ++i) {
            const SolverBody& body = i ? second : first;
            m_end[i] = Pose{body.position, body.rotation} * rows.c->frames[i];
            m_arm[i] = m_end[i].position - body.position;
        }
        m_offset = m_end[1].position - m_end[0].position;
        m_x = m_end[0].rotation * glm::dvec3(1.0, 0.0, 0.0);
        m_y = m_end[0].rotation * glm::dvec3(0.0, 1.0, 0.0);
        m_z = m_end[0].rotation * glm::dvec3(0.0, 0.0, 1.0);
        m_otherX = m_end[1].rotation * glm::dvec3(1.0, 0.0, 0.0);
        m_rotation = glm::conjugate(m_end[0].rotation) * m_end[1].rotation;
        if (m_rotation.w < 0.0) m_rotation = -m_rotation;
        m_rows.rows = 0;
    }

    void build() {
        switch (m_joint.kind) {
            case JointKind::Ball:
            case JointKind::Cone:
                return buildBall();
            case JointKind::Hinge:
                return buildHinge();
            case JointKind::Fixed:
                lockPoint();
                return lockRotation();
            case JointKind::Prismatic:
                return buildPrismatic();
            case JointKind::Wheel:
                return buildWheel();
            case JointKind::Rope:
                return buildRope();
        }
    }
    /// No joint: one row, along or about a direction of the world.
    void build(const BodyConstraint& constraint) {
        const glm::dvec3& axis = constraint.direction;
        m_rows.freeAxis.row = constraint.turns ? rotationRow(axis) : pointRow(axis);
    }
    /// A grab that drives: its rows hold velocities of the body, which is its first end, against the world.
    void drive() {
        m_rows.error = {};
        for (int i = 0; i < m_rows.rows; ++i)
            m_rows.speed[size_t(i)] = i < 3 ? -m_joint.velocity[i] : -m_joint.angularVelocity[i - 3];
    }

private:
    void lock(const JointRow& row, double error) {
        m_rows.error[size_t(m_rows.rows)] = error;
        m_rows.speed[size_t(m_rows.rows)] = 0.0;
        m_rows.row[size_t(m_rows.rows++)] = row;
    }
    /// The velocity of end 1 relative to end 0 along an axis that is fixed to the first body.
    JointRow slidingRow(const glm::dvec3& axis) const {
        return {axis, glm::cross(m_arm[0] + m_offset, axis), axis, glm::cross(m_arm[1], axis)};
    }
    /// The same along an axis of the world.
    JointRow pointRow(const glm::dvec3& axis) const {
        return {axis, glm::cross(m_arm[0], axis), axis, glm::cross(m_arm[1], axis)};
    }
    static JointRow rotationRow(const glm::dvec3& axis) { return {{}, axis, {}, axis}; }
    void lockSliding(const glm::dvec3& axis) { lock(slidingRow(axis), glm::dot(m_offset, axis)); }
    /// The two ends coincide.
    void lockPoint() {
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 axis(0.0);
            axis[i] = 1.0;
            lock(pointRow(axis), m_offset[i]);
        }
    }
    /// End 1's x axis lies along `axis`; side1 and side2 are across it.
    void lockAxis(const glm::dvec3& axis, const glm::dvec3& side1, const glm::dvec3& side2) {
        const glm::dvec3 tilt = glm::cross(axis, m_otherX);
        lock(rotationRow(side1), glm::dot(tilt, side1));
        lock(rotationRow(side2), glm::dot(tilt, side2));
    }
    /// The ends have the same rotation. For small errors the rotation vector is twice the quaternion's vector part.
    void lockRotation() {
        const glm::dvec3 error = m_end[0].rotation * (2.0 * glm::dvec3(m_rotation.x, m_rotation.y, m_rotation.z));
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 axis(0.0);
            axis[i] = 1.0;
            lock(rotationRow(axis), error[i]);
        }
    }

    /// The free coordinate is the angle between the ends' x axes.
    void buildBall() {
        lockPoint();
        if (!hasOnlyUpperLimit(m_joint)) return;
        const glm::dvec3 axis = glm::cross(m_x, m_otherX);
        const double sine = glm::length(axis);
        m_rows.freeAxis.row = rotationRow(sine > 1e-9 ? axis / sine : glm::dvec3(0.0));
        m_rows.freeAxis.value = deterministicAtan2(sine, glm::dot(m_x, m_otherX));
    }
    void buildHinge() {
        lockPoint();
        lockAxis(m_x, m_y, m_z);
        m_rows.freeAxis.row = rotationRow(m_x);
        m_rows.freeAxis.value = twistAboutX(m_rotation);
    }
    void buildPrismatic() {
        lockSliding(m_y);
        lockSliding(m_z);
        lockRotation();
        m_rows.freeAxis.row = slidingRow(m_x);
        m_rows.freeAxis.value = glm::dot(m_offset, m_x);
    }
    /// The free axis is the suspension along y; the motor's is the axle, which steering turns about y.
    void buildWheel() {
        lockSliding(m_x);
        lockSliding(m_z);
        double cosine, sine;
        deterministicCosSin(m_joint.steer, cosine, sine);
        const glm::dvec3 axle = m_x * cosine - m_z * sine;
        lockAxis(axle, m_y, glm::cross(axle, m_y));
        m_rows.freeAxis.row = slidingRow(m_y);
        m_rows.freeAxis.value = glm::dot(m_offset, m_y);
        m_rows.motorAxis.row = rotationRow(axle);
    }
    /// The free coordinate is the length of the path from end to end over what the rope lies on; its row pulls each
    /// body along the rope's last segment.
    void buildRope() {
        const std::vector<glm::dvec3>& bends = m_rows.c->bendPoints;
        const glm::dvec3 first = m_end[0].position - (bends.empty() ? m_end[1].position : bends.front());
        const glm::dvec3 last = m_end[1].position - (bends.empty() ? m_end[0].position : bends.back());
        const double firstLength = glm::length(first), lastLength = glm::length(last);
        const glm::dvec3 pullA = firstLength > 1e-6 ? first / firstLength : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3 pullB = lastLength > 1e-6 ? last / lastLength : glm::dvec3(0.0, -1.0, 0.0);
        FreeAxis& length = m_rows.freeAxis;
        length.row = {-pullA, glm::cross(m_arm[0], -pullA), pullB, glm::cross(m_arm[1], pullB)};
        length.value = bends.empty() ? firstLength : firstLength + lastLength;
        for (size_t i = 1; i < bends.size(); ++i) length.value += glm::length(bends[i] - bends[i - 1]);
    }

    JointRows& m_rows;
    const Joint& m_joint;
    std::array<Pose, 2> m_end;  ///< the joint's frames, world
    std::array<glm::dvec3, 2> m_arm;
    glm::dvec3 m_offset;                ///< from end 0 to end 1
    glm::dvec3 m_x, m_y, m_z;           ///< axes of end 0
    glm::dvec3 m_otherX;                ///< of end 1
    glm::dquat m_rotation{1, 0, 0, 0};  ///< of end 1 relative to end 0
};

/// Whether anything acts along a joint's free axis.
bool isAxisUsed(const Joint& joint) {
    return joint.motor.mode != MotorMode::Off || joint.spring.hertz > 0.0 || joint.friction > 0.0 || joint.limits.on;
}

/// A body after a substep in which nothing changes its velocities.
SolverBody movedBody(SolverBody body, const SolverState& state, double seconds, bool isFast) {
    body.velocity = state.v, body.angularVelocity = state.w;
    body.position += body.velocity * seconds;
    body.conservesMomentum &= isFast;
    rotateBody(body, seconds);
    return body;
}

/// M^-1 of a row: the changes of velocity by a unit impulse along it, of the first body against it.
JointRow changeBy(const JointRow& row, const SolverState& A, const SolverState& B) {
    return {row.linearA * double(A.inverseMass), glm::dmat3(A.inverseInertia) * row.angularA,
            row.linearB * double(B.inverseMass), glm::dmat3(B.inverseInertia) * row.angularB};
}
double dot(const JointRow& a, const JointRow& b) {
    return glm::dot(a.linearA, b.linearA) + glm::dot(a.angularA, b.angularA) + glm::dot(a.linearB, b.linearB) +
           glm::dot(a.angularB, b.angularB);
}

}  // namespace

double JointRow::velocity(const SolverState& A, const SolverState& B) const {
    return glm::dot(linearB, glm::dvec3(B.v)) + glm::dot(angularB, glm::dvec3(B.w)) -
           glm::dot(linearA, glm::dvec3(A.v)) - glm::dot(angularA, glm::dvec3(A.w));
}

void JointRow::apply(SolverState& A, SolverState& B, double impulse) const {
    A.v -= glm::vec3(linearA * (impulse * A.inverseMass));
    A.w -= A.inverseInertia * glm::vec3(angularA * impulse);
    B.v += glm::vec3(linearB * (impulse * B.inverseMass));
    B.w += B.inverseInertia * glm::vec3(angularB * impulse);
}

double JointRow::effectiveMass(const SolverState& A, const SolverState& B) const {
    const double k = double(A.inverseMass) * glm::dot(linearA, linearA) +
                     double(B.inverseMass) * glm::dot(linearB, linearB) +
                     glm::dot(angularA, glm::dmat3(A.inverseInertia) * angularA) +
                     glm::dot(angularB, glm::dmat3(B.inverseInertia) * angularB);
    return k > 0.0 ? 1.0 / k : 0.0;
}

void computeRows(JointRows& rows, std::span<const SolverBody> bodies) {
    RowBuilder builder(rows, bodies[size_t(rows.c->bodies[0])], bodies[size_t(rows.c->bodies[1])]);
    if (rows.c->constraint) return builder.build(*rows.c->constraint);
    builder.build();
    if (rows.c->joint->drives) builder.drive();
}

void addArcs(JointRows& e, std::span<const SolverBody> bodies, std::span<const SolverState> states, double seconds,
             bool isFast) {
    const auto [a, b] = e.c->bodies;
    const SolverState &A = states[size_t(a)], &B = states[size_t(b)];
    JointRows moved;
    moved.c = e.c;
    RowBuilder(moved, movedBody(bodies[size_t(a)], A, seconds, isFast),
               movedBody(bodies[size_t(b)], B, seconds, isFast))
        .build();
    for (size_t r = 0; r < size_t(e.rows); ++r)
        e.arc[r] = (moved.error[r] - e.error[r]) / seconds - e.row[r].velocity(A, B);
    if (e.c->joint->kind == JointKind::Rope || e.c->joint->kind == JointKind::Prismatic)
        e.freeAxis.arc = (moved.freeAxis.value - e.freeAxis.value) / seconds - e.freeAxis.row.velocity(A, B);
}

void factorize(JointRows& e, const SolverState& A, const SolverState& B) {
    const double inverseMassA = double(A.inverseMass), inverseMassB = double(B.inverseMass);
    const glm::dmat3 inverseInertiaA(A.inverseInertia), inverseInertiaB(B.inverseInertia);
    double k[6][6];
    for (int j = 0; j < e.rows; ++j) {
        const JointRow& row = e.row[size_t(j)];
        const glm::dvec3 a = inverseInertiaA * row.angularA, b = inverseInertiaB * row.angularB;
        for (int i = j; i < e.rows; ++i) {
            const JointRow& other = e.row[size_t(i)];
            k[i][j] = inverseMassA * glm::dot(row.linearA, other.linearA) +
                      inverseMassB * glm::dot(row.linearB, other.linearB) + glm::dot(a, other.angularA) +
                      glm::dot(b, other.angularB);
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

void solveBlock(const JointRows& e, std::array<double, 6>& x, int count) {
    for (int i = 0; i < count; ++i)
        for (int m = 0; m < i; ++m) x[size_t(i)] -= e.lower[size_t(i)][size_t(m)] * x[size_t(m)];
    for (int i = 0; i < count; ++i)
        x[size_t(i)] = e.diagonal[size_t(i)] > 0.0 ? x[size_t(i)] / e.diagonal[size_t(i)] : 0.0;
    for (int i = count - 1; i >= 0; --i)
        for (int m = i + 1; m < count; ++m) x[size_t(i)] -= e.lower[size_t(m)][size_t(i)] * x[size_t(m)];
}

void projectFreeAxes(JointRows& e, const SolverState& A, const SolverState& B) {
    const JointKind kind = e.c->joint->kind;
    FreeAxis& axis = e.freeAxis;
    axis.push = axis.row;
    if (e.isInSystem && (kind == JointKind::Hinge || kind == JointKind::Prismatic) && isAxisUsed(*e.c->joint)) {
        factorize(e, A, B);
        const JointRow moved = changeBy(axis.row, A, B);
        for (size_t r = 0; r < size_t(e.rows); ++r) axis.held[r] = dot(e.row[r], moved);
        solveBlock(e, axis.held, e.rows);
        for (size_t r = 0; r < size_t(e.rows); ++r) {
            axis.push.linearA -= e.row[r].linearA * axis.held[r],
                axis.push.angularA -= e.row[r].angularA * axis.held[r];
            axis.push.linearB -= e.row[r].linearB * axis.held[r],
                axis.push.angularB -= e.row[r].angularB * axis.held[r];
        }
    }
    axis.mass = axis.push.effectiveMass(A, B);
    FreeAxis& motor = e.motorAxis;
    if (kind != JointKind::Wheel) {
        motor = axis;
    } else {
        motor.push = motor.row;
        motor.mass = motor.push.effectiveMass(A, B);
    }
}

double velocityError(const JointRows& e, int row, const SolverState& A, const SolverState& B, bool useBias) {
    const double speed = e.speed[size_t(row)] - e.row[size_t(row)].velocity(A, B);
    if (!useBias) return speed;
    const double correction = e.errorRate * e.error[size_t(row)];
    return speed - e.arc[size_t(row)] - std::max(-kMaxCorrectionSpeed, std::min(correction, kMaxCorrectionSpeed));
}

}  // namespace rubble
