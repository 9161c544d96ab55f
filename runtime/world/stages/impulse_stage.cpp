#include <algorithm>
#include <cmath>

#include "runtime/core/log.h"
#include "runtime/core/random.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {
namespace {

constexpr double kBlastRadiusRatio = 2.5;  ///< radius of the push as a multiple of the explosion's size
constexpr double kBlastImpulse = 1500.0;   ///< N s at the centre for size 1, if the edit does not say
constexpr double kMaxBlastSpeed =
    9.0;  ///< m/s that a blast of size 1 gives at most: light pieces do not become bullets
constexpr double kImpactOffset =
    0.2;  ///< of a body's mean radius: how far from its centre of mass it is hit, so that it tumbles

/// A point of the unit cube around zero, the same for a body at every run.
glm::dvec3 randomOffset(BodyHandle body, uint64_t step) {
    Random random(body.slot(), step);
    const float x = random.unit();
    const float y = random.unit();
    const float z = random.unit();
    return glm::dvec3(x, y, z) * 2.0 - 1.0;
}

}  // namespace

void EditStep::apply(const ImpulseEdit& edit) {
    m_deferredImpulses.emplace_back(edit);
}

void EditStep::applyImpulseTo(const ImpulseApplied& impulse) {
    wake(impulse.body);
    m_changes.impulses.push_back(impulse);
}

void EditStep::applyImpulse(const ImpulseEdit& edit) {
    const Body* body = m_world.m_bodies.find(edit.body);
    if (!body)
        logWarning("ImpulseEdit: the handle of its body is stale; nothing was pushed");
    else if (!body->isStatic)
        applyImpulseTo({edit.body, edit.position, edit.impulse});
}

void EditStep::applyImpulse(const ExplodeEdit& edit) {
    const double blastRadius = kBlastRadiusRatio * edit.size;
    const double maxImpulse = edit.impulse > 0.0 ? edit.impulse : kBlastImpulse * edit.size * edit.size;
    std::vector<BodyHandle> near;
    for (const ShapeHandle shape : m_world.shapesNear(edit.position, blastRadius))
        near.push_back(m_world.m_shapes.at(shape).body);
    std::sort(near.begin(), near.end(), [](BodyHandle a, BodyHandle b) { return a.slot() < b.slot(); });
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const BodyHandle handle : near) {
        const Body& body = m_world.m_bodies.at(handle);
        if (body.isStatic) continue;
        const MassProperties mass = m_world.bodyMass(handle);
        const glm::dvec3 center = body.pose.transformPoint(mass.center);
        const glm::dvec3 away = center - edit.position;
        const double distance = glm::length(away);
        if (!(distance < blastRadius) || mass.mass <= 0.0) continue;
        const glm::dvec3 direction = distance > 1e-6 ? away / distance : glm::dvec3(0.0, 1.0, 0.0);
        const double size =
            std::min(maxImpulse, mass.mass * kMaxBlastSpeed * edit.size) * (1.0 - distance / blastRadius);
        const double meanRadius = std::sqrt(mass.principalInertia.x / mass.mass);
        applyImpulseTo(
            {handle, center + randomOffset(handle, m_changes.step) * (kImpactOffset * meanRadius), direction * size});
    }
}

}  // namespace rubble
