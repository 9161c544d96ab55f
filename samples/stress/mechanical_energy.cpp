#include "samples/stress/mechanical_energy.h"

#include <cmath>

namespace rubble {

double MechanicalEnergy::energyOf(const World& world, const Body& body, const MassProperties& mass) {
    const glm::dvec3 w = glm::conjugate(body.pose.rotation * mass.principalAxes) * body.angularVelocity;
    const double kinetic =
        0.5 * (mass.mass * glm::dot(body.velocity, body.velocity) + glm::dot(w, mass.principalInertia * w));
    return kinetic -
           mass.mass * glm::dot(glm::dvec3(world.environment().gravity), body.pose.transformPoint(mass.center));
}

void MechanicalEnergy::reset(const World& world) {
    m_bodies.clear();
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.isStatic) return;
        const MassProperties mass = bodyMass(world, handle);
        m_bodies.push_back({handle, mass, energyOf(world, body, mass), !body.asleep});
    });
    m_hasBaseline = true;
}

void MechanicalEnergy::update(const World& world, const FrameChanges& changes) {
    const bool isQuiet = !changes.levelReplaced && changes.bodiesCreated.empty() && changes.bodiesDestroyed.empty() &&
                         changes.carved.empty() && changes.impulses.empty() && changes.teleported.empty() &&
                         changes.shapesCreated.empty() && changes.shapesDestroyed.empty();
    if (!isQuiet || !m_hasBaseline) return reset(world);
    double change = 0.0;
    for (BodyEnergy& entry : m_bodies) {
        const Body& body = world.bodies().at(entry.body);
        if (body.asleep && !entry.awake) continue;
        const double energy = energyOf(world, body, entry.mass);
        change += energy - entry.energy;
        entry.energy = energy;
        entry.awake = !body.asleep;
    }
    ++m_comparedSteps;
    (change > 0.0 ? m_gained : m_lost) += std::abs(change);
}

}  // namespace rubble
