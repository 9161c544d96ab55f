#include "physics/solver/joint_work.h"

// The work of an impulse x along a row is x (Jv + Jv') / 2, with the row's velocities before and after all that acts at
// the same time. The order in which the solver finds the impulses says nothing: a motor that pushes against a limit, a
// contact or another motor does no work, though it seems to brake what the other has just accelerated.

namespace rubble {
namespace {

constexpr size_t kFreeAxis = 6, kMotorAxis = 7;

/// Calls f(number, row, impulse) for what may add energy.
template <class F>
void forEachSource(const JointRows& e, F&& f) {
    const JointConstraint& c = *e.c;
    for (size_t r = 0; e.isSoft && r < size_t(e.rows); ++r) f(r, e.row[r], c.lockedImpulse[r]);
    f(kFreeAxis, e.freeAxis.row, c.springImpulse + (e.isSoft ? c.limitImpulse[0] - c.limitImpulse[1] : 0.0));
    f(kMotorAxis, e.motorAxis.row, c.motorImpulse);
}

}  // namespace

void JointWork::begin(std::span<const JointRows> joints, std::span<const SolverState> states, const glm::dvec3& early,
                      bool isWhole) {
    m_early = early;
    m_starts.resize(joints.size());
    for (size_t i = 0; i < joints.size(); ++i) {
        const JointRows& e = joints[i];
        forEachSource(e, [&](size_t number, const JointRow& row, double impulse) {
            m_starts[i][number] = {row.velocity(e.stateA(states), e.stateB(states)), isWhole ? 0.0 : impulse};
        });
    }
}

void JointWork::end(std::span<const JointRows> joints, std::span<const SolverState> states) {
    for (size_t i = 0; i < joints.size(); ++i) {
        const JointRows& e = joints[i];
        const SolverState &A = e.stateA(states), &B = e.stateB(states);
        forEachSource(e, [&](size_t number, const JointRow& row, double impulse) {
            const Start& start = m_starts[i][number];
            if (impulse == start.impulse) return;
            const double fallen = glm::dot(row.linearB, m_early) * double(B.gravityScale) -
                                  glm::dot(row.linearA, m_early) * double(A.gravityScale);
            e.c->work += (impulse - start.impulse) * (0.5 * (start.velocity + row.velocity(A, B)) - fallen);
        });
    }
}

}  // namespace rubble
