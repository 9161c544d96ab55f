#include "runtime/world/stages/impulse_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/core/random.h"
#include "runtime/world/objects/body_mass.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/queries/query.h"

namespace rubble {
namespace {

constexpr double kBlastRadiusRatio = 2.5;  ///< radius of the push as a multiple of the explosion's size
constexpr size_t kMaxPushed = 256;         ///< bodies that one blast pushes: the nearest
constexpr double kBlastImpulse = 1500.0;   ///< N s at the centre for size 1, unless the edit sets it
constexpr double kMaxBlastSpeed = 9.0;     ///< m/s from a blast of size 1: light pieces do not become bullets
constexpr double kOpenRadiusRatio = 0.4;   ///< of its size: what stands within that, hard voxels too, shelters nothing
constexpr double kSmallBody = 0.6;         ///< metres across, up to which one ray says whether a body is sheltered
/// Metres from the side of a body to where a blast acts on it; its centre of mass, if that is nearer to the blast.
constexpr double kBlastDepth = 0.3;
/// Share of a body's smallest radius of gyration from its centre to where it is hit: it tumbles. Of a larger one, a
/// blast would spin rods like drills.
constexpr double kImpactOffset = 0.2;
constexpr double kMaxBlastSpin = 100.0;  ///< rad/s from a blast, about: crumbs of small voxels do not whir

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

/// A body that a blast may push.
struct Blasted {
    BodyHandle body;
    glm::dvec3 center{0.0};  ///< of mass, world
    double distance = 0.0;   ///< metres from the blast to where it acts on the body
    int places = 1;          ///< of the body that the blast may see
    int seen = 0;            ///< of these
};

/// Leaves the nearest kMaxPushed of bodies that are sorted by slot, in that order.
void keepNearest(std::vector<Blasted>& bodies) {
    if (bodies.size() <= kMaxPushed) return;
    const auto isNearer = [](const Blasted& a, const Blasted& b) {
        return std::pair(a.distance, a.body.slot()) < std::pair(b.distance, b.body.slot());
    };
    const auto isBefore = [](const Blasted& a, const Blasted& b) { return a.body.slot() < b.body.slot(); };
    std::nth_element(bodies.begin(), bodies.begin() + kMaxPushed, bodies.end(), isNearer);
    bodies.resize(kMaxPushed);
    std::sort(bodies.begin(), bodies.end(), isBefore);
}

/// Metres from a point to the nearest one of the boxes around a body's grids.
double distanceToBoxes(const WorldData& world, const Body& body, glm::dvec3 position) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const ShapeHandle handle : body.shapes) {
        const Shape& shape = world.shapes.at(handle);
        const glm::dvec3 local = shapeToWorld(world, handle).inversePoint(position);
        const glm::dvec3 size = glm::dvec3(shape.grid.size()) * double(shape.voxelSize);
        nearest = std::min(nearest, glm::distance(local, glm::clamp(local, glm::dvec3(0.0), size)));
    }
    return nearest;
}

/// The nearest of the dynamic bodies on which a blast of that radius acts, by slot.
std::vector<Blasted> bodiesNear(const WorldData& world, glm::dvec3 position, double blastRadius) {
    std::vector<BodyHandle> near;
    for (const ShapeHandle shape : shapesNear(world, position, blastRadius))
        near.push_back(world.shapes.at(shape).body);
    std::sort(near.begin(), near.end(), [](BodyHandle a, BodyHandle b) { return a.slot() < b.slot(); });
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::vector<Blasted> found;
    for (const BodyHandle handle : near) {
        const Body& body = world.bodies.at(handle);
        if (body.isStatic) continue;
        const MassProperties mass = bodyMass(world, handle);
        const glm::dvec3 center = body.pose.transformPoint(mass.center);
        const double distance =
            std::min(glm::distance(center, position), distanceToBoxes(world, body, position) + kBlastDepth);
        if (distance < blastRadius && mass.mass > 0.0) found.push_back({handle, center, distance});
    }
    keepNearest(found);
    return found;
}

/// Counts the places of each body that a blast sees past what stands still after it has broken what it breaks: its
/// centre of mass, and if it is large the places halfway from there to the corners of its bounds.
void findExposed(const WorldData& world, std::vector<Blasted>& bodies, const ExplodeEdit& blast) {
    std::vector<RayQuery> rays;
    std::vector<size_t> bodyOf;  // by ray
    for (size_t n = 0; n < bodies.size(); ++n) {
        Blasted& body = bodies[n];
        const WorldBox bounds = bodyBounds(world, body.body);
        if (glm::length(bounds.high - bounds.low) > kSmallBody) body.places = 9;
        for (int i = 0; i < body.places; ++i) {
            const int corner = i - 1;
            const glm::dvec3 end(corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                                 corner & 4 ? bounds.high.z : bounds.low.z);
            const glm::dvec3 from = i == 0 ? body.center : glm::mix(body.center, end, 0.5), way = blast.position - from;
            const double distance = glm::length(way) - kOpenRadiusRatio * blast.size;
            ++body.seen;
            if (!(distance > 0.0)) continue;
            rays.push_back({from, way, distance});
            bodyOf.push_back(n);
        }
    }
    const auto hide = [&](size_t first, std::span<const WorldHit> hits) {
        for (size_t i = 0; i < hits.size(); ++i) bodies[bodyOf[first + i]].seen -= hits[i].hit;
    };
    castRays(world, rays, hide, {.rejectDynamic = true, .rejectUnphysical = true});
}

void applyImpulse(EditContext& context, const ExplodeEdit& edit) {
    const double blastRadius = kBlastRadiusRatio * edit.size;
    const double maxImpulse = edit.impulse > 0.0 ? edit.impulse : kBlastImpulse * edit.size * edit.size;
    std::vector<Blasted> bodies = bodiesNear(context.world, edit.position, blastRadius);
    findExposed(context.world, bodies, edit);
    for (const Blasted& blasted : bodies) {
        if (blasted.seen == 0) continue;
        const MassProperties mass = bodyMass(context.world, blasted.body);
        const glm::dvec3 away = blasted.center - edit.position;
        const double length = glm::length(away), share = double(blasted.seen) / blasted.places;
        const glm::dvec3 direction = length > 1e-6 ? away / length : glm::dvec3(0.0, 1.0, 0.0);
        const double size = std::min(maxImpulse, mass.mass * kMaxBlastSpeed * edit.size) *
                            (1.0 - blasted.distance / blastRadius) * share;
        const glm::dvec3& inertia = mass.principalInertia;
        const double gyration2 = std::min({inertia.x, inertia.y, inertia.z}) / mass.mass;
        const double arm = std::min(kImpactOffset * std::sqrt(gyration2), kMaxBlastSpin * gyration2 * mass.mass / size);
        const glm::dvec3 offset = randomOffset(blasted.body, context.changes.step) * arm;
        applyImpulseTo(context, {blasted.body, blasted.center + offset, direction * size});
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
