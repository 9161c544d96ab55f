#include "runtime/world/queries/query.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "runtime/world/objects/transforms.h"
#include "runtime/world/queries/query_parts.h"

namespace rubble {
namespace {

VoxelGrid gridOf(const GroundSlab& slab) {
    VoxelGrid grid({slab.cubes.x, 1, slab.cubes.y});
    GridWriter cubes(grid);
    for (int z = 0; z < slab.cubes.y; ++z)
        for (int x = 0; x < slab.cubes.x; ++x) cubes.set({x, 0, z}, 1);
    cubes.flush();
    return grid;
}

/// Of a sphere or capsule that overlaps voxels where it starts, the contact with the nearest one. Gives the distance to
/// it from the centre, or from the axis, in cells.
double moveToNearest(const VoxelGrid& grid, const CellShape& round, glm::dvec3 direction, EntryFilter accepted,
                     CellContact& touch) {
    const ClosestVoxel nearest = findClosest(grid, round.a, round.b, round.radius, accepted);
    if (!nearest.found) return round.radius;
    touch.cell = nearest.cell;
    touch.point = nearest.to.onBox;
    if (nearest.to.distance > 0.0)
        touch.normal = (nearest.to.onSegment - nearest.to.onBox) / nearest.to.distance;
    else if (direction != glm::dvec3(0.0))
        touch.normal = -direction;
    return nearest.to.distance;
}

/// One cast through the shapes of a world.
class WorldCast {
public:
    WorldCast(const CastQuery& cast, glm::dvec3 direction) : m_shape(cast.shape), m_direction(direction) {
        m_best.distance = cast.maxDistance;
    }

    void visit(const VoxelGrid& grid, const Pose& pose, double size, EntryFilter accepted, ShapeHandle handle) {
        const CellShape cells = m_shape.inCells(pose, size);
        const glm::dvec3 direction = glm::conjugate(pose.rotation) * m_direction;
        CellContact touch = castShape(grid, cells, direction, m_best.distance / size, accepted);
        if (!touch.hit) return;
        double gap = 0.0;
        if (touch.t == 0.0 && m_shape.kind != QueryShapeKind::Box)
            gap = moveToNearest(grid, cells, direction, accepted, touch) * size;
        const double distance = touch.t * size;
        const bool isNearer = !m_best.hit || distance < m_best.distance || (distance == m_best.distance && gap < m_gap);
        const bool isEqual = m_best.hit && distance == m_best.distance && gap == m_gap;
        if (!isNearer && !(isEqual && handle && handle.slot() < m_best.shape.slot())) return;
        m_gap = gap;
        m_best = {true, distance, pose.transformPoint(touch.point * size), pose.rotation * touch.normal, handle};
        if (!handle) return;  // the ground
        m_best.cell = touch.cell;
        m_best.entry = grid.at(touch.cell);
    }

    const WorldHit& best() const { return m_best; }

private:
    const QueryShape& m_shape;
    glm::dvec3 m_direction;
    WorldHit m_best;
    double m_gap = 0.0;  ///< metres, of one that overlaps where it starts
};

WorldHit castShapeWith(const WorldData& world, const CastQuery& cast, ShapeFilter& filter) {
    const glm::dvec3 direction = unitVector(cast.direction);
    if (!(cast.maxDistance >= 0.0) || (direction == glm::dvec3(0.0) && cast.maxDistance != 0.0)) return {};
    WorldCast found(cast, direction);
    const WorldBox bounds = cast.shape.bounds();
    const glm::dvec3 middle = (bounds.low + bounds.high) * 0.5, halfExtent = (bounds.high - bounds.low) * 0.5;
    const auto mayMeet = [&](const WorldBox& box) {
        return intersects(box, halfExtent, middle, direction, found.best().distance);
    };
    forEachShape(world, filter, mayMeet, [&](ShapeHandle handle, const Shape& shape) {
        found.visit(shape.grid, shapeToWorld(world, handle), shape.voxelSize, filter.entries(shape), handle);
    });
    for (const GroundSlab& slab : filter.ground())
        if (mayMeet(boxOf(slab))) found.visit(gridOf(slab), Pose{slab.low}, slab.side, nullptr, {});
    return found.best();
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

WorldHit castShape(const WorldData& world, const CastQuery& cast, const QueryFilter& filter) {
    ShapeFilter shapes(world, filter);
    return castShapeWith(world, cast, shapes);
}

void castShapes(const WorldData& world, std::span<const CastQuery> casts, const HitSink& sink,
                const QueryFilter& filter, const ParallelFor& parallelFor) {
    inBatches(casts, sink, parallelFor, [&](std::span<const CastQuery> queries, std::span<WorldHit> hits) {
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
    out.reserve(16);
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
        const glm::dvec3 from = pose.inversePoint(point) / size;
        const auto [found, cell, to] = findClosest(shape.grid, from, from, best.distance / size, shapes.entries(shape));
        if (!found || !isBetter(to.distance * size, handle.slot(), best)) return;
        const glm::dvec3 at = pose.transformPoint(to.onBox * size);
        const glm::dvec3 away = point - at;
        const double length = glm::length(away);
        best = {
            true, to.distance * size, at, to.distance > 0.0 && length > 0.0 ? away / length : glm::dvec3(0.0), handle,
            cell, shape.grid.at(cell)};
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
