#include "runtime/world/stages/impulse_stage.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/random.h"
#include "runtime/world/objects/body_mass.h"
#include "runtime/world/queries/query.h"

namespace rubble {
namespace {

constexpr double kBlastRadiusRatio = 2.5;  ///< radius of the push as a multiple of the explosion's size
constexpr double kBlastImpulse = 1500.0;   ///< N s at the centre for size 1, unless the edit sets it
constexpr double kMaxBlastSpeed = 9.0;     ///< m/s from a blast of size 1: light pieces do not become bullets
constexpr double kImpactOffset = 0.2;  ///< share of a body's mean radius from its centre to where it is hit: it tumbles

/// A point of the cube from -1 to 1, the same for a body in every run.
glm::dvec3 randomOffset(BodyHandle body, uint64_t step) {
    Random random(body.slot(), step);
    const float x = random.unit();
    const float y = random.unit();
    const float z = random.unit();
    return glm::dvec3(x, y, z) * 2.0 - 1.0;
}

void applyImpulseTo(EditContext& context, const ImpulseApplied& impulse) {
    context.wakeBody(impulse.body);
    context.changes.impulses.push_back(impulse);
}

void applyImpulse(EditContext& context, const ImpulseEdit& edit) {
    const Body* body = context.world.bodies.find(edit.body);
    if (!body)
        context.warnStale(edit.body, "apply_impulse: the handle of its body is stale; nothing was pushed");
    else if (!body->isStatic)
        applyImpulseTo(context, {edit.body, edit.position, edit.impulse});
}

void applyImpulse(EditContext& context, const ExplodeEdit& edit) {
    const double blastRadius = kBlastRadiusRatio * edit.size;
    const double maxImpulse = edit.impulse > 0.0 ? edit.impulse : kBlastImpulse * edit.size * edit.size;
    std::vector<BodyHandle> near;
    for (const ShapeHandle shape : shapesNear(context.world, edit.position, blastRadius))
        near.push_back(context.world.shapes.at(shape).body);
    std::sort(near.begin(), near.end(), [](BodyHandle a, BodyHandle b) { return a.slot() < b.slot(); });
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const BodyHandle handle : near) {
        const Body& body = context.world.bodies.at(handle);
        if (body.isStatic) continue;
        const MassProperties mass = bodyMass(context.world, handle);
        const glm::dvec3 center = body.pose.transformPoint(mass.center);
        const glm::dvec3 away = center - edit.position;
        const double distance = glm::length(away);
        if (!(distance < blastRadius) || mass.mass <= 0.0) continue;
        const glm::dvec3 direction = distance > 1e-6 ? away / distance : glm::dvec3(0.0, 1.0, 0.0);
        const double size =
            std::min(maxImpulse, mass.mass * kMaxBlastSpeed * edit.size) * (1.0 - distance / blastRadius);
        const double meanRadius = std::sqrt(mass.principalInertia.x / mass.mass);
        applyImpulseTo(context,
                       {handle, center + randomOffset(handle, context.changes.step) * (kImpactOffset * meanRadius),
                        direction * size});
    }
}

}  // namespace

void apply(EditContext& context, const ImpulseEdit& edit) {
    context.impulses.emplace_back(edit);
}

void updateVelocities(EditContext& context) {
    for (const auto& [slot, motion] : context.motions) {
        Body* body = context.world.bodies.find(motion.body);
        if (!body) continue;
        const glm::dvec3 center = body->pose.transformPoint(bodyMass(context.world, motion.body).center);
        if (center == motion.center) continue;
        body->velocity = motion.velocityAt(center);
    }
}

void applyImpulses(EditContext& context) {
    for (const auto& each : context.impulses) std::visit([&](const auto& edit) { applyImpulse(context, edit); }, each);
}

}  // namespace rubble
