#include <optional>

#include "runtime/core/wide_tree.h"
#include "runtime/voxel/ray_walk.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/queries/query_parts.h"
#include "runtime/world/queries/ray_order.h"

// Rays through the world. One alone asks the tree of bounds. Many share what a ray would do again for each shape: a
// wide tree in floats, from near to far, and the poses of all shapes; and very many are cast in an order in which they
// meet what is in the caches. All give the same answers, bit for bit.

namespace rubble {
namespace {

/// What a batch must have of rays to look at all shapes first: of each two shapes one, and these.
constexpr size_t kShapesPerRay = 2, kMinRays = 16;
constexpr size_t kMinOrdered = 1024;  ///< rays: an order costs as much for fewer, and less is gained
/// By which a ray goes on behind the best hit, so that rounding into the cells of another grid hides none at the same
/// distance.
constexpr double kBeyondBest = 1.0 + 1e-12;

/// Where a ray enters a box that it does not begin in; false: nowhere nearer than `best`.
bool enterBox(const WorldBox& box, glm::dvec3 origin, glm::dvec3 direction, WorldHit& best) {
    if (!intersects(box, glm::dvec3(0.0), origin, direction, best.distance)) return false;
    double distance = 0.0;
    int side = -1;
    for (int a = 0; a < 3; ++a) {
        if (direction[a] == 0.0) continue;
        const double enter = ((direction[a] > 0.0 ? box.low[a] : box.high[a]) - origin[a]) / direction[a];
        if (enter > distance) distance = enter, side = a;
    }
    if (best.hit && distance >= best.distance) return false;
    best = {.hit = true, .distance = distance, .position = origin + direction * distance, .normal = -direction};
    if (side < 0) return true;
    best.normal = glm::dvec3(0.0);
    best.normal[side] = direction[side] > 0.0 ? -1.0 : 1.0;
    return true;
}

/// A ray with its unit direction, and the best hit so far.
struct RayState {
    /// The best is none, at the largest distance.
    explicit RayState(const RayQuery& ray) : origin(ray.origin), direction(unitVector(ray.direction)) {
        if (isEmpty(ray)) return;
        best.distance = ray.maxDistance;
    }
    /// Whether it can hit nothing.
    bool isEmpty(const RayQuery& ray) const { return direction == glm::dvec3(0.0) || !(ray.maxDistance > 0.0); }

    glm::dvec3 origin, direction;
    WorldHit best;
};

/// Walks a ray through one shape. pose: of its grid. entries: see ShapeFilter.
void visitShape(ShapeHandle handle, const Shape& shape, const Pose& pose, EntryFilter entries, RayState& ray) {
    const double cellsPerMetre = 1.0 / shape.voxelSize;
    const CellRay cells{pose.inversePoint(ray.origin) * cellsPerMetre, glm::conjugate(pose.rotation) * ray.direction,
                        ray.best.distance * cellsPerMetre * kBeyondBest};
    const CellHit hit = walkRay(shape.grid, cells, entries);
    const double distance = hit.t * shape.voxelSize;
    if (!hit.hit || !isBetter(distance, handle.slot(), ray.best)) return;
    glm::dvec3 normalLocal(0.0);
    if (hit.axis >= 0) normalLocal[hit.axis] = hit.sign;
    ray.best = {true,
                distance,
                ray.origin + ray.direction * distance,
                hit.axis < 0 ? -ray.direction : pose.rotation * normalLocal,
                handle,
                hit.cell,
                shape.grid.at(hit.cell)};
}

WorldHit castRayWith(const WorldData& world, const RayQuery& query, ShapeFilter& filter) {
    RayState ray(query);
    if (ray.isEmpty(query)) return ray.best;
    forEachShape(
        world, filter,
        [&](const WorldBox& box) {
            return intersects(box, glm::dvec3(0.0), ray.origin, ray.direction, ray.best.distance);
        },
        [&](ShapeHandle handle, const Shape& shape) {
            visitShape(handle, shape, shapeToWorld(world, handle), filter.entries(shape), ray);
        });
    for (const GroundSlab& slab : filter.ground()) enterBox(boxOf(slab), ray.origin, ray.direction, ray.best);
    return ray.best;
}

/// What all rays of a batch may meet.
class RayBatch {
public:
    RayBatch(const WorldData& world, const QueryFilter& filter) : m_world(world), m_tree(world.shapeBounds) {
        const ShapeFilter shapes(world, filter);
        m_targets.resize(world.shapes.slotCount());
        for (const uint32_t slot : m_tree.items()) {
            const ShapeHandle handle = world.shapes.handleAt(slot);
            const Shape& shape = world.shapes.at(handle);
            if (shapes.accepts(handle, shape)) m_targets[slot] = {handle, &shape, shapeToWorld(world, handle)};
        }
    }

    WorldHit cast(const RayQuery& query, ShapeFilter& filter) const {
        RayState ray(query);
        if (ray.isEmpty(query) || !m_tree.isExactFor(ray.origin)) return castRayWith(m_world, query, filter);
        m_tree.findAlong(ray.origin, ray.direction, ray.best.distance, [&](uint32_t slot) {
            const Target& target = m_targets[slot];
            if (target.shape) visitShape(target.handle, *target.shape, target.pose, filter.entries(*target.shape), ray);
            return ray.best.distance;
        });
        for (const GroundSlab& slab : filter.ground()) enterBox(boxOf(slab), ray.origin, ray.direction, ray.best);
        return ray.best;
    }

private:
    struct Target {
        ShapeHandle handle;
        const Shape* shape = nullptr;  ///< null: the filter rejects it
        Pose pose;
    };
    const WorldData& m_world;
    WideTree m_tree;
    std::vector<Target> m_targets;  ///< by slot
};

/// Casts the spheres among the rays.
void castSpheres(const WorldData& world, std::span<const RayQuery> rays, std::span<WorldHit> out,
                 const QueryFilter& filter) {
    std::vector<CastQuery> casts;
    std::vector<size_t> places;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!(rays[i].radius > 0.0)) continue;
        places.push_back(i);
        casts.push_back(
            {{.position = rays[i].origin, .radius = rays[i].radius}, rays[i].direction, rays[i].maxDistance});
    }
    if (casts.empty()) return;
    const auto place = [&](size_t first, std::span<const WorldHit> hits) {
        for (size_t i = 0; i < hits.size(); ++i) out[places[first + i]] = hits[i];
    };
    castShapes(world, casts, place, filter);
}

}  // namespace

WorldHit castRay(const WorldData& world, const RayQuery& ray, const QueryFilter& filter) {
    if (ray.radius > 0.0)
        return castShape(world, {{.position = ray.origin, .radius = ray.radius}, ray.direction, ray.maxDistance},
                         filter);
    ShapeFilter shapes(world, filter);
    return castRayWith(world, ray, shapes);
}

void castRays(const WorldData& world, std::span<const RayQuery> rays, const HitSink& sink, const QueryFilter& filter,
              const ParallelFor& parallelFor) {
    std::optional<RayBatch> shared;
    if (rays.size() >= kMinRays && rays.size() * kShapesPerRay >= world.shapes.slotCount())
        shared.emplace(world, filter);
    const auto answer = [&](std::span<const RayQuery> queries, std::span<WorldHit> hits) {
        ShapeFilter shapes(world, filter);
        for (size_t i = 0; i < queries.size(); ++i)
            if (!(queries[i].radius > 0.0))
                hits[i] = shared ? shared->cast(queries[i], shapes) : castRayWith(world, queries[i], shapes);
        castSpheres(world, queries, hits, filter);
    };
    if (rays.size() < kMinOrdered) return inBatches(rays, sink, parallelFor, answer);
    const std::vector<uint32_t> order = coherentOrder(rays);
    inOrderedBatches(rays, std::span(order), sink, parallelFor, answer);
}

}  // namespace rubble
