#pragma once
#include <algorithm>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "runtime/core/parallel_for.h"
#include "runtime/core/world_box.h"
#include "runtime/voxel/grid_cast.h"
#include "runtime/world/state/world_data.h"

namespace rubble {

// Questions about a world, in world space and metres. They only read: any number may run at the same time on any
// threads while nobody changes the world. Each costs what is near it, by the tree of bounds and the bricks, and answers
// from the voxels themselves. A NaN finds nothing. Answers do not depend on the order in which shapes are visited: of
// equal ones the lowest slot counts.

/// What a ray or a moved shape meets first. Of the solid ground around a level (BoundsRule::Ground) `shape` is empty
/// and `entry` 0: filters see it as a static shape of layer 1.
struct WorldHit {
    bool hit = false;
    double distance = 0.0;     ///< metres; without a hit: how far was searched
    glm::dvec3 position{0.0};  ///< on the voxel's surface
    glm::dvec3 normal{0.0};    ///< of the voxel's face or edge, away from the voxel
    ShapeHandle shape;
    glm::ivec3 cell{0};
    uint8_t entry = 0;  ///< of the shape's palette
};

/// Which shapes and voxels a query sees.
struct QueryFilter {
    uint8_t layerMask = 255;                           ///< only shapes with a collision layer in this mask
    bool rejectStatic = false, rejectDynamic = false;  ///< bodies of this kind are not found
    bool rejectTransparent = false;  ///< passes through voxels of entries that are not opaque, such as glass
    bool rejectUnphysical = false;   ///< passes through voxels of unphysical materials, which bodies pass through too
    std::vector<BodyHandle> rejectedBodies;
    std::vector<ShapeHandle> rejectedShapes;
};

struct RayQuery {
    glm::dvec3 origin{0.0}, direction{0.0};  ///< the direction may have any length but 0
    double maxDistance = 1000.0;
    double radius = 0.0;  ///< > 0: a sphere is cast
};

enum class QueryShapeKind : uint8_t { Sphere, Box, Capsule };
struct QueryShape {
    QueryShapeKind kind = QueryShapeKind::Sphere;
    glm::dvec3 position{0.0};         ///< sphere and box: centre; capsule: one end
    glm::dvec3 end{0.0};              ///< capsule: the other end
    double radius = 0.5;              ///< sphere and capsule
    glm::dvec3 halfSize{0.5};         ///< box
    glm::dquat rotation{1, 0, 0, 0};  ///< box

    /// The smallest world box around it.
    WorldBox bounds() const;
    /// The same shape in cells of a grid whose corner is at `gridToWorld`.
    CellShape inCells(const Pose& gridToWorld, double voxelSize) const;
};

struct CastQuery {
    QueryShape shape;
    glm::dvec3 direction{0.0};  ///< may have any length but 0; 0 is allowed if maxDistance is 0
    double maxDistance = 1000.0;
};

/// The first voxel on a ray, by an exact walk through the cells. For a sphere, `position` is the point of contact and
/// `distance` how far its centre travels.
WorldHit castRay(const WorldData& world, const RayQuery& ray, const QueryFilter& filter = {});
/// Takes the answers to queries first, first + 1, ... of many. [any thread, at the same time]
using HitSink = std::function<void(size_t first, std::span<const WorldHit> hits)>;

/// castRay() for many, in batches that `parallelFor` may run at the same time.
void castRays(const WorldData& world, std::span<const RayQuery> rays, const HitSink& sink,
              const QueryFilter& filter = {}, const ParallelFor& parallelFor = serialFor);

/// The first voxel that a shape touches when it is moved without turning; distance 0 if they touch at the start. The
/// normal points from the voxel to the shape.
WorldHit castShape(const WorldData& world, const CastQuery& cast, const QueryFilter& filter = {});
/// castShape() for many, as castRays().
void castShapes(const WorldData& world, std::span<const CastQuery> casts, const HitSink& sink,
                const QueryFilter& filter = {}, const ParallelFor& parallelFor = serialFor);
/// Fills a list: out[i] answers query i.
inline HitSink hitsInto(std::span<WorldHit> out) {
    return [out](size_t first, std::span<const WorldHit> hits) {
        std::copy(hits.begin(), hits.end(), out.begin() + std::ptrdiff_t(first));
    };
}

/// Shapes with a voxel in a region, in slot order.
std::vector<ShapeHandle> overlappingShapes(const WorldData& world, const QueryShape& region,
                                           const QueryFilter& filter = {});
/// Bodies with a voxel in a region, in slot order.
std::vector<BodyHandle> overlappingBodies(const WorldData& world, const QueryShape& region,
                                          const QueryFilter& filter = {});
/// Whether a live body has a voxel in a region.
bool overlapsBody(const WorldData& world, BodyHandle body, const QueryShape& region, const QueryFilter& filter = {});

/// Shapes whose grid's bounds overlap a box, in slot order. Cheaper than overlappingShapes(), and coarser.
std::vector<ShapeHandle> shapesInBox(const WorldData& world, const WorldBox& box, const QueryFilter& filter = {});
/// Bodies with a shape of shapesInBox(), in slot order.
std::vector<BodyHandle> bodiesInBox(const WorldData& world, const WorldBox& box, const QueryFilter& filter = {});
/// Shapes whose grid's bounds overlap the cube of half side `radius` around a point, in slot order, unfiltered.
std::vector<ShapeHandle> shapesNear(const WorldData& world, glm::dvec3 point, double radius);

/// The point of a voxel that is closest to a point; the normal points to it, distance 0 inside a voxel.
WorldHit closestPoint(const WorldData& world, glm::dvec3 point, double maxDistance, const QueryFilter& filter = {});

/// The box around all voxels of a live body; empty (low > high) if it has none.
WorldBox bodyBounds(const WorldData& world, BodyHandle body);

}  // namespace rubble
