#include "physics/solver/energy_bound.h"

#include <algorithm>
#include <cmath>

// A swing is measured in the middle of a substep. Substeps are those of the leapfrog method: positions are those of
// their ends, velocities those of their middles. At the ends its energy would rise and fall with the height of half a
// substep's motion, and who cuts off what rises damps every pendulum. What is left of that, a swing loses and regains:
// bodies remember what their islands lost lately, up to a thousandth of the motion of those with joints, and that much
// may come back. So may what contacts lose and give back as their separations, in float, rise and fall: taken from
// the speed of what slides slowly, it would stop it. Where a motor turns what spins fast, it may come first: else the
// motor's speed, which is little beside the spin, would pay. And so may a millionth of the motion of an island without
// the world, whose velocities are rounded to float: else the speeds of its bodies against each other, which may be
// little beside their common one, would pay for what that has gained.
//
// Where an island's energy is taken back from:
//   * Of contacts with the world: from the speeds of the bodies that gained, in proportion to their gains, and then
//   from
//     their heights, but for two millimetres a step: overlaps are pushed apart in the end.
//   * With joints to the world: the speeds of all its bodies are scaled alike, so that joined bodies stay together;
//   then
//     heights as above.
//   * Without the world: momentum P and angular momentum L must stay. With the mass M, the inertia I about the centre
//   of
//     mass and the velocities v_i, w_i of the bodies at r_i from it, the motion as one rigid body is V = P / M and
//     W = I^-1 L. The rest, v_i - V - W x r_i and w_i - W, has neither momentum, and its energy adds to that of the
//     rigid motion. It alone is scaled.
//
// A body that was put back (continuous_collision.h) has velocities that it got from hits after that moment, elsewhere:
// P is right, L is not. An island without the world gets what is missing of L as a turn of the whole, and what energy
// that adds is taken back in the same way.

namespace rubble {
namespace {

constexpr double kArcError = 0.05;         ///< of an energy by (w h)^2, by which a driven swing may be off
constexpr double kMaxLift = 0.002;         ///< metres by which an overlap may lift a body in a step
constexpr double kMaxRegain = 1e-3;        ///< of its kinetic energy, that an island with joints may gain back
constexpr double kMaxDrivenRegain = 1e-4;  ///< the same where a motor makes up for what is lost
constexpr double kHeightNoise = 2e-8;      ///< metres by which what rests on contacts may fall and rise again
/// Of the kinetic energy of a free island. A velocity v is rounded to float by at most 2^-24 of each component, which
/// changes m v^2 / 2 by 2^-23 of it, 1.2e-7. That occurs once where no impulse acts, and at random where some do.
constexpr double kRounding = 1e-6;

/// Takes back height that a body gained from nothing, as far as it rose in the step. gain: joules.
void lower(SolverBody& body, const glm::dvec3& before, double gain, const glm::dvec3& gravity) {
    const double weight = glm::length(gravity) / body.inverseMass;
    if (!(weight > 0.0)) return;
    const glm::dvec3 up = gravity / -glm::length(gravity);
    const double lift = std::min(gain / weight, glm::dot(body.position - before, up));
    if (lift > kMaxLift) body.position -= up * (lift - kMaxLift);
}

}  // namespace

/// The motion of bodies as one rigid body of the same momentum and angular momentum.
struct EnergyBound::RigidMotion {
    double mass = 0.0, energy = 0.0;                   ///< kg, joules
    glm::dvec3 center{0.0}, velocity{0.0}, spin{0.0};  ///< of the centre of mass, world axes
    glm::dmat3 inertia{0.0};                           ///< about it

    RigidMotion(std::span<const SolverBody> bodies, Members members) {
        for (const auto& [root, i] : members) {
            const double m = 1.0 / bodies[i].inverseMass;
            mass += m;
            center += bodies[i].position * m;
            velocity += bodies[i].velocity * m;
        }
        center /= mass, velocity /= mass;
        glm::dvec3 momentum(0.0);
        for (const auto& [root, i] : members) {
            const SolverBody& body = bodies[i];
            const glm::dvec3 r = body.position - center;
            inertia += glm::inverse(worldInverseInertia(body)) +
                       (glm::dmat3(glm::dot(r, r)) - glm::outerProduct(r, r)) / body.inverseMass;
            momentum += glm::cross(r, (body.velocity - velocity) / body.inverseMass) + angularMomentum(body);
        }
        spin = glm::inverse(inertia) * momentum;
        energy = 0.5 * (mass * glm::dot(velocity, velocity) + glm::dot(spin, momentum));
    }
    glm::dvec3 velocityAt(const glm::dvec3& point) const { return velocity + glm::cross(spin, point - center); }
};

void EnergyBound::record(std::span<const SolverBody> bodies, const glm::dvec3& gravity, double substep) {
    m_gravity = gravity;
    m_lag = 0.5 * substep;
    m_before.resize(bodies.size());
    for (size_t i = 1; i < bodies.size(); ++i)
        m_before[i] = {kineticEnergy(bodies[i]), bodies[i].position, bodies[i].velocity};
}

void EnergyBound::findIslands(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs,
                              std::span<JointConstraint* const> joints) {
    m_sets = UnionFind<>(bodies.size());
    const auto unite = [&](int a, int b) {
        if (a && b) m_sets.unite(uint32_t(a), uint32_t(b));
    };
    for (const auto& [a, b] : pairs) unite(a, b);
    for (const JointConstraint* joint : joints) unite(joint->bodies[0], joint->bodies[1]);
    m_islands.assign(bodies.size(), {});
    for (const auto& [a, b] : pairs)
        if (!a || !b) m_islands[m_sets.root(uint32_t(a + b))].touchesWorld = true;
    for (const JointConstraint* joint : joints) {
        const auto [a, b] = joint->bodies;
        Island& island = m_islands[m_sets.root(uint32_t(std::max(a, b)))];
        ++island.joints;
        island.touchesWorld = island.touchesWorld || !a || !b;
        island.gain -= joint->work;
        island.isDriven |= joint->joint->motor.mode != MotorMode::Off && joint->joint->kind != JointKind::Rope;
    }
    m_gains.resize(bodies.size());
    for (uint32_t i = 1; i < bodies.size(); ++i) {
        Island& island = m_islands[m_sets.root(i)];
        const Before& before = m_before[i];
        const double kinetic = kineticEnergy(bodies[i]);
        glm::dvec3 moved = bodies[i].position - before.position;
        if (island.joints) moved -= (bodies[i].velocity - before.velocity) * m_lag;
        // Potential energy that became kinetic.
        const double fallen = glm::dot(m_gravity, moved) * double(bodies[i].gravityScale) / bodies[i].inverseMass;
        m_gains[i] = kinetic - fallen - before.kinetic;
        island.gain += m_gains[i];
        island.regainable += bodies[i].regainable;
        island.weight += glm::length(m_gravity) / bodies[i].inverseMass;
        ++island.bodies;
        island.positiveGains += std::max(m_gains[i], 0.0);
        island.kinetic += kinetic;
        const double turn = 2.0 * m_lag * glm::length(bodies[i].angularVelocity);
        if (island.isDriven) island.advance += std::min(kArcError * turn * turn, kMaxRegain) * kinetic;
    }
}

void EnergyBound::enforce(std::span<SolverBody> bodies, std::span<const std::pair<int, int>> pairs,
                          std::span<JointConstraint* const> joints) {
    findIslands(bodies, pairs, joints);
    updateRegainable(bodies);
    takeFromGainers(bodies);
    const auto isMeant = [](const Island& island) { return island.gain > 0.0 && !island.touchesWorld; };
    forEachIsland(bodies.size(), isMeant,
                  [&](const Island& island, Members members) { takeFromInnerMotion(bodies, island, members); });
}

/// What the islands gained back does not count as a gain.
void EnergyBound::updateRegainable(std::span<SolverBody> bodies) {
    for (Island& island : m_islands)
        if (!island.touchesWorld) island.advance += kRounding * island.kinetic;
    for (uint32_t i = 1; i < bodies.size(); ++i) {
        const Island& island = m_islands[m_sets.root(i)];
        const double most = kHeightNoise * island.weight +
                            (island.joints ? (island.isDriven ? kMaxDrivenRegain : kMaxRegain) * island.kinetic : 0.0);
        bodies[i].regainable = std::clamp(island.regainable - island.gain, -island.advance, most) / island.bodies;
    }
    for (Island& island : m_islands) island.gain -= std::max(island.regainable + island.advance, 0.0);
}

void EnergyBound::takeFromGainers(std::span<SolverBody> bodies) {
    for (uint32_t i = 1; i < bodies.size(); ++i) {
        const Island& island = m_islands[m_sets.root(i)];
        if (!island.touchesWorld || !(island.gain > 0.0)) continue;
        // Joules to take from this body's height and speed, and of what its speed is part of.
        const double share = m_gains[i] > 0.0 ? m_gains[i] / island.positiveGains : 0.0;
        const double excess = island.joints ? island.gain : island.gain * share;
        const double kinetic = island.joints ? island.kinetic : kineticEnergy(bodies[i]);
        if (!(excess > 0.0)) continue;
        const double height = island.joints ? (excess - kinetic) * share : excess - kinetic;
        const double scale = excess < kinetic ? std::sqrt(1.0 - excess / kinetic) : 0.0;
        bodies[i].velocity *= scale;
        bodies[i].angularVelocity *= scale;
        if (height > 0.0) lower(bodies[i], m_before[i].position, height, m_gravity);
    }
}

/// The bodies of the islands of which `isMeant` is true, each island's together: calls f(root, bodies).
template <class Meant, class F>
void EnergyBound::forEachIsland(size_t bodies, Meant&& isMeant, F&& f) {
    m_members.clear();
    for (uint32_t i = 1; i < bodies; ++i)
        if (const uint32_t root = m_sets.root(i); isMeant(m_islands[root])) m_members.emplace_back(root, i);
    std::sort(m_members.begin(), m_members.end());
    for (size_t from = 0, to = 0; from < m_members.size(); from = to) {
        while (to < m_members.size() && m_members[to].first == m_members[from].first) ++to;
        f(m_islands[m_members[from].first], Members(m_members).subspan(from, to - from));
    }
}

/// Of a free island.
void EnergyBound::takeFromInnerMotion(std::span<SolverBody> bodies, const Island& island, Members members) {
    const RigidMotion rigid(bodies, members);
    const double inner = island.kinetic - rigid.energy;
    if (!(inner > 0.0)) return;
    const double scale = std::sqrt(std::max(0.0, 1.0 - island.gain / inner));
    for (const auto& [root, i] : members) {
        SolverBody& body = bodies[i];
        const glm::dvec3 asOne = rigid.velocityAt(body.position);
        body.velocity = asOne + (body.velocity - asOne) * scale;
        body.angularVelocity = rigid.spin + (body.angularVelocity - rigid.spin) * scale;
    }
}

/// What is missing of an island's angular momentum it gets as one rigid body.
void EnergyBound::keepMomentum(std::span<const SolverBody> before, std::span<SolverBody> bodies) {
    for (Island& island : m_islands) island.changed = false;
    for (uint32_t i = 1; i < bodies.size(); ++i)
        if (bodies[i].position != before[i].position || bodies[i].rotation != before[i].rotation)
            m_islands[m_sets.root(i)].changed = true;
    const auto isMeant = [](const Island& island) { return island.changed && !island.touchesWorld; };
    forEachIsland(bodies.size(), isMeant, [&](Island& island, Members members) {
        glm::dvec3 missing(0.0);
        double allowed = 0.0;
        for (const auto& [root, i] : members) {
            SolverBody was = before[i];
            was.velocity = bodies[i].velocity;
            missing += angularMomentum(was) - angularMomentum(bodies[i]) +
                       glm::cross(was.position - bodies[i].position, was.velocity / was.inverseMass);
            allowed += kineticEnergy(was);
        }
        const RigidMotion rigid(bodies, members);
        const glm::dvec3 spin = glm::inverse(rigid.inertia) * missing;
        island.kinetic = 0.0;
        for (const auto& [root, i] : members) {
            bodies[i].velocity += glm::cross(spin, bodies[i].position - rigid.center);
            bodies[i].angularVelocity += spin;
            island.kinetic += kineticEnergy(bodies[i]);
        }
        island.gain = island.kinetic - allowed;
        if (island.gain > 0.0) takeFromInnerMotion(bodies, island, members);
    });
}

}  // namespace rubble
