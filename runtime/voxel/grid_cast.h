#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// A convex shape in the cells of a grid: a sphere (a = b), a capsule (all within `radius` of the segment a b), or an
/// oriented box about `a`.
struct CellShape {
    glm::dvec3 a{0.0}, b{0.0};  ///< ends of the segment; box: `a` is its centre
    double radius = 0.0;        ///< of a sphere or capsule
    bool isBox = false;
    std::array<glm::dvec3, 3> halfAxes{};  ///< box: orthogonal, from the centre to a face

    /// The centre of its bounding box.
    glm::dvec3 middle() const { return isBox ? a : (a + b) * 0.5; }
    /// Half the size of its axis-aligned bounding box.
    glm::dvec3 halfExtent() const;
};

/// Where a shape touches a voxel. Cells of the grid.
struct CellContact {
    bool hit = false;
    glm::ivec3 cell{0};
    double t = 0.0;          ///< 0: it touches where it starts
    glm::dvec3 point{0.0};   ///< the point of the voxel that is touched
    glm::dvec3 normal{0.0};  ///< unit, from the voxel to the shape; -direction if the shape's centre starts inside
};

/// By palette entry: whether its voxels count. Null: all do.
using EntryFilter = const std::array<bool, 256>*;

/// [any-thread] The first solid voxel that the shape touches when it moves along `direction`, up to t = tMax (t counts
/// in multiples of `direction`, which need not be unit). Voxels are closed unit cubes; t is exact to 1e-9 cells of
/// distance. A voxel that the shape touches at the start but moves along or away from does not stop it. The cost grows
/// with the bricks near the path up to the hit. A NaN anywhere gives no hit.
CellContact castShape(const VoxelGrid& grid, const CellShape& shape, glm::dvec3 direction, double tMax,
                      EntryFilter accepted = nullptr);

/// [any-thread] A solid voxel that the shape overlaps or touches: the first in the order of bricks and cells; none if
/// there is none.
std::optional<glm::ivec3> findOverlap(const VoxelGrid& grid, const CellShape& shape, EntryFilter accepted = nullptr);

/// [any-thread] The solid voxel that a sphere or capsule penetrates most. `t` is the distance between its segment and
/// the voxel, at most the radius. The normal is zero where the segment itself is inside the voxel.
CellContact findDeepest(const VoxelGrid& grid, const CellShape& round);

/// The result of closestToBox().
struct SegmentToBox {
    glm::dvec3 onSegment{0.0}, onBox{0.0};
    double distance = 0.0;  ///< between the two points; 0 if segment and box meet
};
/// The result of findClosest(), in cells.
struct ClosestVoxel {
    bool found = false;
    glm::ivec3 cell{0};
    SegmentToBox to;  ///< the voxel
};
/// [any-thread] The point of all solid voxels that is closest to the segment a b, if one is within `maxDistance` cells.
ClosestVoxel findClosest(const VoxelGrid& grid, glm::dvec3 a, glm::dvec3 b, double maxDistance,
                         EntryFilter accepted = nullptr);

/// The closest points of the segment a b and the axis-aligned box [low, high].
SegmentToBox closestToBox(glm::dvec3 a, glm::dvec3 b, glm::dvec3 low, glm::dvec3 high);

}  // namespace rubble
