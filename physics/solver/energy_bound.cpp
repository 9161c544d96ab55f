#include "physics/solver/energy_bound.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// Joules.
double kineticEnergy(const SolverBody& body) {
    const glm::dvec3 w = glm::conjugate(body.rotation) * body.angularVelocity;
    return 0.5 * (glm::dot(body.velocity, body.velocity) / body.inverseMass + glm::dot(w, body.inertia * w));
}

constexpr double kMaxLift = 0.0005;  ///< metres by which an overlap may lift a body in a step

/// Takes back height that a body gained from nothing, as far as it rose in the step. gain: joules.
void lower(SolverBody& body, const glm::dvec3& before, double gain, const glm::dvec3& gravity) {
    const double weight = glm::length(gravity) / body.inverseMass;
    if (!(weight > 0.0)) return;
    const glm::dvec3 up = gravity / -glm::length(gravity);
    const double lift = std::min(gain / weight, glm::dot(body.position - before, up));
    if (lift > kMaxLift) body.position -= up * (lift - kMaxLift);
}

}  // namespace

void EnergyBound::record(std::span<const SolverBody> bodies) {
    m_before.resize(bodies.size());
    for (size_t i = 1; i < bodies.size(); ++i) m_before[i] = {kineticEnergy(bodies[i]), bodies[i].position};
}

void EnergyBound::enforce(std::span<SolverBody> bodies, std::span<const std::pair<int, int>> pairs,
                          std::span<JointConstraint* const> joints, const glm::dvec3& gravity) {
    UnionFind<> sets(bodies.size());
    for (const auto& [a, b] : pairs)
        if (a && b) sets.unite(uint32_t(a), uint32_t(b));
    m_islands.assign(bodies.size(), {});
    for (const auto& [a, b] : pairs)
        if (!a || !b) m_islands[sets.root(uint32_t(a + b))].touchesWorld = true;
    for (const JointConstraint* joint : joints)
        for (const int body : joint->bodies) m_islands[sets.root(uint32_t(body))].hasJoints = true;
    m_gains.resize(bodies.size());
    for (uint32_t i = 1; i < bodies.size(); ++i) {
        // Potential energy that has become kinetic.
        const double fallen = glm::dot(gravity, bodies[i].position - m_before[i].position) / bodies[i].inverseMass;
        m_gains[i] = kineticEnergy(bodies[i]) - fallen - m_before[i].kinetic;
        Island& island = m_islands[sets.root(i)];
        island.gain += m_gains[i];
        island.positiveGains += std::max(m_gains[i], 0.0);
    }
    for (uint32_t i = 1; i < bodies.size(); ++i) {
        const Island& island = m_islands[sets.root(i)];
        if (!island.touchesWorld || island.hasJoints || !(island.gain > 0.0) || !(m_gains[i] > 0.0)) continue;
        const double kinetic = kineticEnergy(bodies[i]),
                     left = kinetic - m_gains[i] * island.gain / island.positiveGains;
        const double scale = left > 0.0 ? std::sqrt(left / kinetic) : 0.0;
        bodies[i].velocity *= scale;
        bodies[i].angularVelocity *= scale;
        if (left < 0.0) lower(bodies[i], m_before[i].position, -left, gravity);
    }
}

}  // namespace rubble
