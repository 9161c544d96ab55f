#include "runtime/world/queries/query.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "runtime/core/assertion.h"
#include "runtime/voxel/ray_walk.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/state/level_ground.h"

namespace rubble {
namespace {

constexpr size_t kBatch = 64;  ///< queries that one call of a ParallelFor's body answers

/// Whether a ray of unit direction meets a box, grown by `halfExtent`, within a distance. The slab method: the ray's
/// interval inside a box is the intersection of its intervals between the three pairs of planes (Kay & Kajiya 1986).
bool intersects(const WorldBox& box, glm::dvec3 halfExtent, glm::dvec3 origin, glm::dvec3 direction, double distance) {
    double enter = 0.0, leave = distance;
    for (int a = 0; a < 3; ++a) {
        const double lowest = box.low[a] - halfExtent[a], highest = box.high[a] + halfExtent[a];
        if (direction[a] == 0.0) {
            if (origin[a] < lowest || origin[a] > highest) return false;
            continue;
        }
        const double low = (lowest - origin[a]) / direction[a], high = (highest - origin[a]) / direction[a];
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    return enter <= leave;
}

/// A filter applied to shapes, with the accepted palette entries of the last one.
class ShapeFilter {
public:
    ShapeFilter(const WorldData& world, const QueryFilter& filter)
        : m_world(world), m_filter(filter), m_filtersEntries(filter.rejectTransparent || filter.rejectUnphysical) {
        if (!filter.rejectStatic && filter.layerMask & Shape{}.collisionLayer) m_ground = groundSlabs(world);
    }

    /// The solid ground, as far as the query sees it.
    const std::vector<GroundSlab>& ground() const { return m_ground; }

    bool accepts(ShapeHandle handle, const Shape& shape) const {
        if (!(shape.collisionLayer & m_filter.layerMask)) return false;
        if (m_filter.rejectStatic || m_filter.rejectDynamic) {
            const bool isStatic = m_world.bodies.at(shape.body).isStatic;
            if (isStatic ? m_filter.rejectStatic : m_filter.rejectDynamic) return false;
        }
        return !has(m_filter.rejectedShapes, handle) && !has(m_filter.rejectedBodies, shape.body);
    }
    /// Entries of the shape's palette that the query sees; null: all.
    EntryFilter entries(const Shape& shape) {
        if (!m_filtersEntries) return nullptr;
        if (m_palette == shape.palette.get()) return m_all ? nullptr : &m_entries;
        m_palette = shape.palette.get();
        for (size_t i = 0; i < 256; ++i) {
            const PaletteEntry& entry = (*m_palette)[i];
            const bool isUnphysical = m_world.materials[entry.material].hardness == Hardness::Unphysical;
            m_entries[i] =
                !(m_filter.rejectTransparent && entry.opacity < 255) && !(m_filter.rejectUnphysical && isUnphysical);
        }
        m_all = std::all_of(m_entries.begin(), m_entries.end(), [](bool accepted) { return accepted; });
        return m_all ? nullptr : &m_entries;
    }

private:
    template <class Handle>
    static bool has(const std::vector<Handle>& list, Handle handle) {
        return std::find(list.begin(), list.end(), handle) != list.end();
    }
    const WorldData& m_world;
    const QueryFilter& m_filter;
    std::vector<GroundSlab> m_ground;
    bool m_filtersEntries, m_all = true;
    const Palette* m_palette = nullptr;
    std::array<bool, 256> m_entries{};
};

/// Calls f(handle, shape) for the accepted shapes whose bounds, with a margin, satisfy isNear(box); in no order.
template <class IsNear, class F>
void forEachShape(const WorldData& world, const ShapeFilter& filter, IsNear&& isNear, F&& f) {
    world.shapeBounds.find(isNear, [&](uint32_t slot) {
        const ShapeHandle handle = world.shapes.handleAt(slot);
        const Shape& shape = world.shapes.at(handle);
        if (filter.accepts(handle, shape)) f(handle, shape);
    });
}

WorldBox boxOf(const GroundSlab& slab) {
    return {slab.low, slab.low + slab.side * glm::dvec3(slab.cubes.x, 1, slab.cubes.y)};
}

VoxelGrid gridOf(const GroundSlab& slab) {
    VoxelGrid grid({slab.cubes.x, 1, slab.cubes.y});
    GridWriter cubes(grid);
    for (int z = 0; z < slab.cubes.y; ++z)
        for (int x = 0; x < slab.cubes.x; ++x) cubes.set({x, 0, z}, 1);
    cubes.flush();
    return grid;
}

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

/// Whether a hit at a distance is better than the best so far: nearer, or as near in a lower slot.
bool isBetter(double distance, uint32_t slot, const WorldHit& best) {
    if (!best.hit) return distance <= best.distance;
    return distance < best.distance || (distance == best.distance && slot < best.shape.slot());
}

/// The unit vector along a direction of any length; zero for zero. Squares of what is below 1e-154 are zero.
glm::dvec3 unitVector(glm::dvec3 direction) {
    const glm::dvec3 size = glm::abs(direction);
    const double largest = std::max({size.x, size.y, size.z});
    if (largest < 1e-100 || largest > 1e100) direction /= largest;
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : glm::dvec3(0.0);
}

WorldHit castRayWith(const WorldData& world, const RayQuery& ray, ShapeFilter& filter) {
    WorldHit best;
    const glm::dvec3 direction = unitVector(ray.direction);
    if (direction == glm::dvec3(0.0) || !(ray.maxDistance > 0.0)) return best;
    best.distance = ray.maxDistance;
    const auto visit = [&](ShapeHandle handle, const Shape& shape) {
        const Pose pose = shapeToWorld(world, handle);
        const double cellsPerMetre = 1.0 / shape.voxelSize;
        const CellRay cells{pose.inversePoint(ray.origin) * cellsPerMetre, glm::conjugate(pose.rotation) * direction,
                            best.distance * cellsPerMetre};
        const CellHit hit = walkRay(shape.grid, cells, filter.entries(shape));
        const double distance = hit.t * shape.voxelSize;
        if (!hit.hit || !isBetter(distance, handle.slot(), best)) return;
        glm::dvec3 normalLocal(0.0);
        if (hit.axis >= 0) normalLocal[hit.axis] = hit.sign;
        best = {true,
                distance,
                ray.origin + direction * distance,
                hit.axis < 0 ? -direction : pose.rotation * normalLocal,
                handle,
                hit.cell,
                shape.grid.at(hit.cell)};
    };
    forEachShape(
        world, filter,
        [&](const WorldBox& box) { return intersects(box, glm::dvec3(0.0), ray.origin, direction, best.distance); },
        visit);
    for (const GroundSlab& slab : filter.ground()) enterBox(boxOf(slab), ray.origin, direction, best);
    return best;
}

WorldHit castShapeWith(const WorldData& world, const CastQuery& cast, ShapeFilter& filter) {
    WorldHit best;
    const glm::dvec3 direction = unitVector(cast.direction);
    if (!(cast.maxDistance >= 0.0) || (direction == glm::dvec3(0.0) && cast.maxDistance != 0.0)) return best;
    best.distance = cast.maxDistance;
    const WorldBox bounds = cast.shape.bounds();
    const glm::dvec3 middle = (bounds.low + bounds.high) * 0.5, halfExtent = (bounds.high - bounds.low) * 0.5;
    const auto visit = [&](ShapeHandle handle, const Shape& shape) {
        const Pose pose = shapeToWorld(world, handle);
        const double size = shape.voxelSize;
        const CellContact touch =
            castShape(shape.grid, cast.shape.inCells(pose, size), glm::conjugate(pose.rotation) * direction,
                      best.distance / size, filter.entries(shape));
        if (!touch.hit || !isBetter(touch.t * size, handle.slot(), best)) return;
        best = {true,
                touch.t * size,
                pose.transformPoint(touch.point * size),
                pose.rotation * touch.normal,
                handle,
                touch.cell,
                shape.grid.at(touch.cell)};
    };
    forEachShape(
        world, filter,
        [&](const WorldBox& box) { return intersects(box, halfExtent, middle, direction, best.distance); }, visit);
    for (const GroundSlab& slab : filter.ground()) {
        if (!intersects(boxOf(slab), halfExtent, middle, direction, best.distance)) continue;
        const Pose pose{slab.low};
        const CellContact touch =
            castShape(gridOf(slab), cast.shape.inCells(pose, slab.side), direction, best.distance / slab.side, nullptr);
        const double distance = touch.t * slab.side;
        if (touch.hit && (!best.hit || distance < best.distance))
            best = {true, distance, pose.transformPoint(touch.point * slab.side), touch.normal};
    }
    return best;
}

template <class Query, class Answer>
void inBatches(std::span<const Query> queries, std::span<WorldHit> out, const ParallelFor& parallelFor,
               Answer&& answer) {
    RUBBLE_ASSERT(queries.size() == out.size());
    const size_t count = queries.size();
    parallelFor((count + kBatch - 1) / kBatch, [&](size_t batch) {
        answer(queries.subspan(batch * kBatch, std::min(kBatch, count - batch * kBatch)), out.subspan(batch * kBatch));
    });
}

template <class Handle>
void sortUnique(std::vector<Handle>& list) {
    std::sort(list.begin(), list.end(), [](Handle a, Handle b) { return a.slot() < b.slot(); });
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

std::vector<BodyHandle> bodiesOf(const WorldData& world, const std::vector<ShapeHandle>& shapes) {
    std::vector<BodyHandle> bodies;
    for (const ShapeHandle shape : shapes) bodies.push_back(world.shapes.at(shape).body);
    sortUnique(bodies);
    return bodies;
}

/// The smallest box around all solid cells.
CellBox solidBox(const VoxelGrid& grid) {
    CellBox box{grid.size(), glm::ivec3(0)};
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const glm::ivec3 low = position * kBrickSize;
        if (glm::all(glm::lessThanEqual(box.low, low)) && glm::all(glm::lessThanEqual(low + kBrickSize, box.high)))
            return;
        forEachVoxel(brick->occupancy, [&](int i) {
            box.low = glm::min(box.low, low + voxelInBrick(i));
            box.high = glm::max(box.high, low + voxelInBrick(i) + 1);
        });
    });
    return box;
}

}  // namespace

WorldBox QueryShape::bounds() const {
    if (kind == QueryShapeKind::Sphere) return {position - radius, position + radius};
    if (kind == QueryShapeKind::Capsule) return {glm::min(position, end) - radius, glm::max(position, end) + radius};
    return boundsOfBox(position, halfSize, rotation);
}

CellShape QueryShape::inCells(const Pose& gridToWorld, double voxelSize) const {
    CellShape out;
    out.a = gridToWorld.inversePoint(position) / voxelSize;
    out.b = kind == QueryShapeKind::Capsule ? gridToWorld.inversePoint(end) / voxelSize : out.a;
    out.radius = radius / voxelSize;
    out.isBox = kind == QueryShapeKind::Box;
    if (!out.isBox) return out;
    const glm::dmat3 axes = glm::mat3_cast(glm::conjugate(gridToWorld.rotation) * rotation);
    for (int i = 0; i < 3; ++i) out.halfAxes[size_t(i)] = axes[i] * (halfSize[i] / voxelSize);
    return out;
}

WorldHit castRay(const WorldData& world, const RayQuery& ray, const QueryFilter& filter) {
    ShapeFilter shapes(world, filter);
    if (!(ray.radius > 0.0)) return castRayWith(world, ray, shapes);
    return castShapeWith(world, {{.position = ray.origin, .radius = ray.radius}, ray.direction, ray.maxDistance},
                         shapes);
}

void castRays(const WorldData& world, std::span<const RayQuery> rays, std::span<WorldHit> out,
              const QueryFilter& filter, const ParallelFor& parallelFor) {
    inBatches(rays, out, parallelFor, [&](std::span<const RayQuery> queries, std::span<WorldHit> hits) {
        ShapeFilter shapes(world, filter);
        for (size_t i = 0; i < queries.size(); ++i) {
            const RayQuery& ray = queries[i];
            hits[i] = ray.radius > 0.0
                          ? castShapeWith(
                                world, {{.position = ray.origin, .radius = ray.radius}, ray.direction, ray.maxDistance},
                                shapes)
                          : castRayWith(world, ray, shapes);
        }
    });
}

WorldHit castShape(const WorldData& world, const CastQuery& cast, const QueryFilter& filter) {
    ShapeFilter shapes(world, filter);
    return castShapeWith(world, cast, shapes);
}

void castShapes(const WorldData& world, std::span<const CastQuery> casts, std::span<WorldHit> out,
                const QueryFilter& filter, const ParallelFor& parallelFor) {
    inBatches(casts, out, parallelFor, [&](std::span<const CastQuery> queries, std::span<WorldHit> hits) {
        ShapeFilter shapes(world, filter);
        for (size_t i = 0; i < queries.size(); ++i) hits[i] = castShapeWith(world, queries[i], shapes);
    });
}

std::vector<ShapeHandle> overlappingShapes(const WorldData& world, const QueryShape& region,
                                           const QueryFilter& filter) {
    ShapeFilter shapes(world, filter);
    const WorldBox bounds = region.bounds();
    std::vector<ShapeHandle> out;
    forEachShape(
        world, shapes, [&](const WorldBox& box) { return box.overlaps(bounds); },
        [&](ShapeHandle handle, const Shape& shape) {
            const CellShape cells = region.inCells(shapeToWorld(world, handle), shape.voxelSize);
            if (findOverlap(shape.grid, cells, shapes.entries(shape))) out.push_back(handle);
        });
    sortUnique(out);
    return out;
}

std::vector<BodyHandle> overlappingBodies(const WorldData& world, const QueryShape& region, const QueryFilter& filter) {
    return bodiesOf(world, overlappingShapes(world, region, filter));
}

bool overlapsBody(const WorldData& world, BodyHandle body, const QueryShape& region, const QueryFilter& filter) {
    ShapeFilter shapes(world, filter);
    for (const ShapeHandle handle : world.bodies.at(body).shapes) {
        const Shape& shape = world.shapes.at(handle);
        if (!shapes.accepts(handle, shape)) continue;
        if (findOverlap(shape.grid, region.inCells(shapeToWorld(world, handle), shape.voxelSize),
                        shapes.entries(shape)))
            return true;
    }
    return false;
}

std::vector<ShapeHandle> shapesInBox(const WorldData& world, const WorldBox& box, const QueryFilter& filter) {
    const ShapeFilter shapes(world, filter);
    std::vector<ShapeHandle> out;
    forEachShape(
        world, shapes, [&](const WorldBox& bounds) { return bounds.overlaps(box); },
        [&](ShapeHandle handle, const Shape&) {
            if (gridBounds(world, handle).overlaps(box)) out.push_back(handle);
        });
    sortUnique(out);
    return out;
}

std::vector<BodyHandle> bodiesInBox(const WorldData& world, const WorldBox& box, const QueryFilter& filter) {
    return bodiesOf(world, shapesInBox(world, box, filter));
}

// The tree's margins depend on how a shape came to where it is, so its bounds are tested again: nothing that happens
// next may depend on past motion.
std::vector<ShapeHandle> shapesNear(const WorldData& world, glm::dvec3 point, double radius) {
    std::vector<ShapeHandle> out;
    if (!(radius >= 0.0)) return out;
    const WorldBox around{point - radius, point + radius};
    const auto visit = [&](uint32_t slot) {
        const ShapeHandle handle = world.shapes.handleAt(slot);
        if (gridBounds(world, handle).overlaps(around)) out.push_back(handle);
    };
    world.shapeBounds.find([&](const WorldBox& box) { return box.overlaps(around); }, visit);
    sortUnique(out);
    return out;
}

WorldHit closestPoint(const WorldData& world, glm::dvec3 point, double maxDistance, const QueryFilter& filter) {
    ShapeFilter shapes(world, filter);
    WorldHit best;
    if (!(maxDistance >= 0.0)) return best;
    best.distance = maxDistance;
    const auto isNear = [&](const WorldBox& box) {
        return glm::length(point - glm::clamp(point, box.low, box.high)) <= best.distance;
    };
    forEachShape(world, shapes, isNear, [&](ShapeHandle handle, const Shape& shape) {
        const Pose pose = shapeToWorld(world, handle);
        const double size = shape.voxelSize;
        const ClosestVoxel closest =
            findClosest(shape.grid, pose.inversePoint(point) / size, best.distance / size, shapes.entries(shape));
        if (!closest.found || !isBetter(closest.distance * size, handle.slot(), best)) return;
        const glm::dvec3 at = pose.transformPoint(closest.point * size);
        const glm::dvec3 away = point - at;
        const double length = glm::length(away);
        best = {true,
                closest.distance * size,
                at,
                closest.distance > 0.0 && length > 0.0 ? away / length : glm::dvec3(0.0),
                handle,
                closest.cell,
                shape.grid.at(closest.cell)};
    });
    for (const GroundSlab& slab : shapes.ground()) {
        const WorldBox box = boxOf(slab);
        const glm::dvec3 at = glm::clamp(point, box.low, box.high);
        const double distance = glm::length(point - at);
        if (best.hit ? distance < best.distance : distance <= best.distance)
            best = {true, distance, at, distance > 0.0 ? (point - at) / distance : glm::dvec3(0.0)};
    }
    return best;
}

WorldBox bodyBounds(const WorldData& world, BodyHandle body) {
    WorldBox bounds{glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (const ShapeHandle handle : world.bodies.at(body).shapes) {
        const Shape& shape = world.shapes.at(handle);
        if (shape.grid.empty()) continue;
        const CellBox cells = solidBox(shape.grid);
        const Pose pose = shapeToWorld(world, handle);
        const double half = 0.5 * shape.voxelSize;
        const QueryShape box{.kind = QueryShapeKind::Box,
                             .position = pose.transformPoint(glm::dvec3(cells.low + cells.high) * half),
                             .halfSize = glm::dvec3(cells.high - cells.low) * half,
                             .rotation = pose.rotation};
        bounds = bounds.merged(box.bounds());
    }
    return bounds;
}

}  // namespace rubble
