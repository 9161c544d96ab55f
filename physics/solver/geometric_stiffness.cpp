#include "physics/solver/geometric_stiffness.h"

#include <algorithm>
#include <cmath>
#include <utility>

// A pull along a light body turns it back into its line, as tension does a string.
//
// A joint that pulls with the force f at the distance r from the centre of mass gives a body that is turned by a small
// angle a the torque -f r a: it swings with w^2 = f r / I. This is a spring that no row of a Jacobian shows, and
// explicit substeps of h seconds are unstable for (w h)^2 > 4: a chain of links of 0.5 kg under 500 kg shakes itself to
// pieces, however exactly its joints are solved. An implicit substep takes h^2 f r into the inertia (Tournier et al.,
// "Stable Constrained Dynamics", 2015; Andrews et al., "Geometric Stiffness for Real-time Constrained Multibody
// Dynamics", 2017). Here the whole inertia grows by it, and only by what is beyond a quarter of what is stable: what
// is slower keeps its motion.

namespace rubble {
namespace {

constexpr double kMaxExplicitTurn = 0.25;  ///< (w h)^2 that explicit substeps do well

/// N s along the common point of a joint, or along a rope; 0 for kinds that hold no point.
double pullOf(const JointConstraint& c) {
    switch (c.joint->kind) {
        case JointKind::Rope:
            return c.limitImpulse[1];
        case JointKind::Prismatic:
        case JointKind::Wheel:
            return 0.0;
        default:
            return glm::length(glm::dvec3(c.lockedImpulse[0], c.lockedImpulse[1], c.lockedImpulse[2]));
    }
}

}  // namespace

void GeometricStiffness::begin(size_t bodies) {
    m_turn.assign(bodies, 0.0);
    m_isSlowed.assign(bodies, false);
    m_pulled.clear();
}

void GeometricStiffness::apply(std::span<const JointRows> joints, std::span<const SolverBody> bodies,
                               std::span<SolverState> states, double seconds) {
    for (const JointRows& e : joints) {
        const double pull = pullOf(*e.c);
        for (size_t side = 0; side < 2 && pull > 0.0; ++side) {
            const int body = e.c->bodies[side];
            const glm::dvec3 &arm = e.c->frames[side].position, &inertia = bodies[size_t(body)].inertia;
            const double r = glm::length(arm);
            if (!body || r == 0.0) continue;
            // The mean of 1 / I about the axes across the arm. The frame of a body is that of its principal axes.
            const glm::dvec3 u = arm / r, inverse = 1.0 / inertia;
            const double across = 0.5 * (inverse.x + inverse.y + inverse.z - glm::dot(inverse, u * u));
            if (m_turn[size_t(body)] == 0.0) m_pulled.push_back(body);
            m_turn[size_t(body)] += seconds * pull * r * across;
        }
    }
    for (const int body : m_pulled) {
        const double turn = std::exchange(m_turn[size_t(body)], 0.0), added = std::max(turn - kMaxExplicitTurn, 0.0);
        if (added == 0.0 && !m_isSlowed[size_t(body)]) continue;
        m_isSlowed[size_t(body)] = true;
        states[size_t(body)].inverseInertia = glm::mat3(worldInverseInertia(bodies[size_t(body)]) / (1.0 + added));
    }
    m_pulled.clear();
}

}  // namespace rubble
