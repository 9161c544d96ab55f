#include "tests/physics/scenes/energy.h"

#include <algorithm>

namespace rubble::known {

double mechanicalEnergy(const World& world, double lag) {
    const glm::dvec3 gravity(world.environment().gravity);
    double sum = 0.0;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.isStatic) return;
        const MassProperties mass = bodyMass(world, handle);
        const glm::dvec3 w = glm::conjugate(body.pose.rotation * mass.principalAxes) * body.angularVelocity;
        const glm::dvec3 v = body.velocity, middle = body.pose.transformPoint(mass.center) - v * lag;
        sum += 0.5 * (mass.mass * glm::dot(v, v) + glm::dot(w, mass.principalInertia * w)) -
               mass.mass * glm::dot(gravity, middle);
    });
    return sum;
}

EnergyRecord::EnergyRecord(const World& world, const PhysicsSettings& settings)
    : m_lag(0.5 * settings.stepSeconds / settings.substeps),
      m_start(mechanicalEnergy(world, m_lag)),
      m_last(m_start),
      m_highest(m_start) {}

void EnergyRecord::update(const World& world, double work) {
    m_work += work;
    const double now = mechanicalEnergy(world, m_lag) - m_work;
    (now > m_last ? m_gained : m_lost) += std::abs(now - m_last);
    m_last = now;
    m_highest = std::max(m_highest, now);
}

}  // namespace rubble::known
