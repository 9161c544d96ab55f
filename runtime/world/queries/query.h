#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "runtime/core/parallel_for.h"
#include "runtime/voxel/grid_cast.h"
#include "runtime/world/world.h"

namespace rubble {

// Questions about a World. They only read: any number may be asked side by side while nobody changes it. Each costs
// what is near it, by the tree of bounds and the bricks, and answers from the voxels themselves. World space, metres. A
// NaN finds nothing. Answers do not depend on the order in which shapes are met: of equals the lowest slot counts.

/// What a question is about.
struct QueryFilter {
    uint8_t layers = 255;  ///< only shapes with a collision layer in this mask
    bool includeStatic = true, includeDynamic = true;
    bool rejectTransparent = false;  ///< passes through voxels of entries that are not opaque, such as glass
    bool rejectUnphysical = false;   ///< passes through what is seen but not editState
    std::vector<BodyHandle> rejectedBodies;
    std::vector<ShapeHandle> rejectedShapes;
};

struct RayQuery {
    glm::dvec3 origin{0.0}, direction{0.0};  ///< the direction need not be unit
    double maxDistance = 1000.0;
    double radius = 0.0;  ///< > 0: a ball is cast
};

enum class QueryShapeKind : uint8_t { Sphere, Capsule, Box };
struct QueryShape {
    QueryShapeKind kind = QueryShapeKind::Sphere;
    glm::dvec3 position{0.0};         ///< sphere and box: middle; capsule: one end
    glm::dvec3 end{0.0};              ///< capsule: the other end
    double radius = 0.5;              ///< sphere and capsule
    glm::dvec3 halfSize{0.5};         ///< box
    glm::dquat rotation{1, 0, 0, 0};  ///< box

    WorldBox bounds() const;
    /// In cells of a grid whose corner is at a pose.
    CellShape inCells(const Pose& gridToWorld, double voxelSize) const;
};

struct CastQuery {
    QueryShape shape;
    glm::dvec3 direction{0.0};  ///< need not be unit
    double maxDistance = 1000.0;
};

/// The first voxel in a ray's way. For a ball, `position` is where it touches and `distance` how far its middle gets.
WorldHit castRay(const World& world, const RayQuery& ray, const QueryFilter& filter = {});
/// The same for many: out[i] answers rays[i].
void castRays(const World& world, std::span<const RayQuery> rays, std::span<WorldHit> out,
              const QueryFilter& filter = {}, const ParallelFor& parallelFor = serialFor);

/// The first voxel that a shape touches when it is moved without turning; distance 0 if it does where it starts. The
/// normal points from the voxel to the shape.
WorldHit castShape(const World& world, const CastQuery& cast, const QueryFilter& filter = {});
void castShapes(const World& world, std::span<const CastQuery> casts, std::span<WorldHit> out,
                const QueryFilter& filter = {}, const ParallelFor& parallelFor = serialFor);

/// Shapes, or bodies, with a voxel in a region, in slot order.
std::vector<ShapeHandle> overlappingShapes(const World& world, const QueryShape& region,
                                           const QueryFilter& filter = {});
std::vector<BodyHandle> overlappingBodies(const World& world, const QueryShape& region, const QueryFilter& filter = {});
/// Whether a body has a voxel in a region.
bool overlapsBody(const World& world, BodyHandle body, const QueryShape& region, const QueryFilter& filter = {});

/// Shapes, or bodies, whose bounds meet a box, in slot order: cheaper, and rougher.
std::vector<ShapeHandle> shapesInBox(const World& world, const WorldBox& box, const QueryFilter& filter = {});
std::vector<BodyHandle> bodiesInBox(const World& world, const WorldBox& box, const QueryFilter& filter = {});

/// The point of a voxel that is closest to a point; the normal points to it, distance 0 inside a voxel.
WorldHit closestPoint(const World& world, glm::dvec3 point, double maxDistance, const QueryFilter& filter = {});

/// Box that holds all voxels of a body; empty (low > high) if it has none.
WorldBox bodyBounds(const World& world, BodyHandle body);

}  // namespace rubble
