#include "samples/stress/demolition/mechanical_energy.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

/// Seconds by which the positions of jointed bodies are later than their velocities: half of one of six substeps.
constexpr double kLag = 1.0 / 720.0;

}  // namespace

double MechanicalEnergy::energyOf(const World& world, const Body& body, const BodyEnergy& entry) {
    const MassProperties& mass = entry.mass;
    const glm::dvec3 w = glm::conjugate(body.pose.rotation * mass.principalAxes) * body.angularVelocity;
    const glm::dvec3 place = body.pose.transformPoint(mass.center) - body.velocity * (entry.jointed ? kLag : 0.0);
    const double kinetic =
        0.5 * (mass.mass * glm::dot(body.velocity, body.velocity) + glm::dot(w, mass.principalInertia * w));
    return kinetic - mass.mass * glm::dot(glm::dvec3(world.environment().gravity), place);
}

void MechanicalEnergy::reset(const World& world) {
    m_bodies.clear();
    std::vector<BodyHandle> jointed;
    world.joints().forEach([&](JointHandle, const Joint& joint) {
        for (const JointEnd& end : joint.ends)
            if (const Shape* shape = world.shapes().find(end.shape)) jointed.push_back(shape->body);
    });
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.isStatic) return;
        BodyEnergy& entry = m_bodies.emplace_back(BodyEnergy{handle, bodyMass(world, handle), 0.0, !body.asleep});
        entry.jointed = std::find(jointed.begin(), jointed.end(), handle) != jointed.end();
        entry.energy = energyOf(world, body, entry);
    });
    m_hasBaseline = true;
}

void MechanicalEnergy::update(const World& world, const FrameChanges& changes, double work) {
    const bool isQuiet = !changes.levelReplaced && changes.bodiesCreated.empty() && changes.bodiesDestroyed.empty() &&
                         changes.carved.empty() && changes.impulses.empty() && changes.teleported.empty() &&
                         changes.shapesCreated.empty() && changes.shapesDestroyed.empty() &&
                         changes.jointsCreated.empty() && changes.jointsBroken.empty();
    if (!isQuiet || !m_hasBaseline) return reset(world);
    double change = -work;
    for (BodyEnergy& entry : m_bodies) {
        const Body& body = world.bodies().at(entry.body);
        if (body.asleep && !entry.awake) continue;
        const double energy = energyOf(world, body, entry);
        change += energy - entry.energy;
        entry.energy = energy;
        entry.awake = !body.asleep;
    }
    ++m_comparedSteps;
    (change > 0.0 ? m_gained : m_lost) += std::abs(change);
}

}  // namespace rubble
