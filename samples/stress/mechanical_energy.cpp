#include "samples/stress/mechanical_energy.h"

#include <algorithm>

namespace rubble {

double MechanicalEnergy::energyOf(const World& world, const Body& body, const MassProperties& mass) {
    const glm::dvec3 w = glm::conjugate(body.pose.rotation * mass.principalAxes) * body.angularVelocity;
    const double kinetic = 0.5 * (mass.mass * glm::dot(body.velocity, body.velocity) + glm::dot(w, mass.principalInertia * w));
    return kinetic - mass.mass * glm::dot(glm::dvec3(world.environment().gravity), body.pose.transformPoint(mass.center));
}

void MechanicalEnergy::beginAnew(const World& world) {
    m_parts.clear();
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.isStatic) return;
        const MassProperties mass = world.bodyMass(handle);
        m_parts.push_back({handle, mass, energyOf(world, body, mass), !body.asleep});
    });
    m_isKnown = true;
}

void MechanicalEnergy::see(const World& world, const FrameChanges& changes) {
    const bool isQuiet = !changes.levelReplaced && changes.bodiesCreated.empty() && changes.bodiesDestroyed.empty() && changes.carved.empty() &&
                         changes.impulses.empty() && changes.teleported.empty() && changes.shapesCreated.empty() && changes.shapesDestroyed.empty();
    if (!isQuiet || !m_isKnown) return beginAnew(world);
    double change = 0.0;
    for (Part& part : m_parts) {
        const Body& body = world.bodies().at(part.body);
        if (body.asleep && !part.awake) continue;
        const double energy = energyOf(world, body, part.mass);
        change += energy - part.energy;
        part.energy = energy;
        part.awake = !body.asleep;
    }
    ++m_compared;
    (change > 0.0 ? m_gained : m_lost) += std::abs(change);
    m_most = std::max(m_most, change);
}

}  // namespace rubble
