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
constexpr double kOpenRadiusRatio = 0.4;   ///< of its size: what stands within that, hard voxels too, shelters nothing
constexpr double kSmallBody = 0.6;         ///< metres across, up to which one ray says whether a body is sheltered
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

/// The share of a body that a blast sees past what stands still after it has broken what it breaks: of its centre of
/// mass, and of the places halfway from there to the corners of its bounds if it is large.
double exposure(const WorldData& world, BodyHandle body, glm::dvec3 center, const ExplodeEdit& blast) {
    const WorldBox bounds = bodyBounds(world, body);
    const bool isLarge = glm::length(bounds.high - bounds.low) > kSmallBody;
    const QueryFilter standing{.rejectDynamic = true, .rejectUnphysical = true};
    const int places = isLarge ? 9 : 1;
    int seen = 0;
    for (int i = 0; i < places; ++i) {
        const int corner = i - 1;
        const glm::dvec3 end(corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                             corner & 4 ? bounds.high.z : bounds.low.z);
        const glm::dvec3 from = i == 0 ? center : glm::mix(center, end, 0.5), way = blast.position - from;
        const double distance = glm::length(way) - kOpenRadiusRatio * blast.size;
        seen += !(distance > 0.0) || !castRay(world, {from, way, distance}, standing).hit;
    }
    return double(seen) / places;
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
        const double share = exposure(context.world, handle, center, edit);
        if (share == 0.0) continue;
        const double size =
            std::min(maxImpulse, mass.mass * kMaxBlastSpeed * edit.size) * (1.0 - distance / blastRadius) * share;
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
