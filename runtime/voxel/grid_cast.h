#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// A convex shape in a grid's own cells: all that is within `radius` of a segment (of a point, if both ends are the
/// same), or a turned box about `a`.
struct CellShape {
    glm::dvec3 a{0.0}, b{0.0};  ///< ends of the segment; box: a is its middle
    double radius = 0.0;        ///< sphere and capsule
    bool isBox = false;
    std::array<glm::dvec3, 3> halfAxes{};  ///< box: at right angles, their lengths are its half sides

    glm::dvec3 middle() const { return isBox ? a : (a + b) * 0.5; }
    /// Half the size of its bounds.
    glm::dvec3 halfExtent() const;
};

struct CellContact {
    bool hit = false;
    glm::ivec3 cell{0};
    double t = 0.0;          ///< 0: it touches where it starts
    glm::dvec3 point{0.0};   ///< of the voxel, where they touch
    glm::dvec3 normal{0.0};  ///< unit, from the voxel to the shape; the way back if the shape's core starts inside
};

/// Palette entries that count; null: all.
using EntryFilter = const std::array<bool, 256>*;

/// The first solid voxel that the shape touches on its way along `direction` (which need not be unit; t counts in its
/// lengths) up to tMax. Voxels are closed unit cubes; the time is exact to about 1e-9 cells of distance. Costs the
/// bricks near the way until it is blocked. What it just touches and moves along or away from does not stop it. A NaN
/// anywhere gives no hit.
CellContact castShape(const VoxelGrid& grid, const CellShape& shape, glm::dvec3 direction, double tMax,
                      EntryFilter accepted = nullptr);

/// A solid voxel that the shape overlaps or touches: the first by brick, then by cell.
std::optional<glm::ivec3> findOverlap(const VoxelGrid& grid, const CellShape& shape, EntryFilter accepted = nullptr);

/// Where a round shape is deepest in a solid voxel, or closest to one that it touches: the least distance between
/// segment and voxel, as `t`. The normal is zero where the segment itself is inside.
CellContact findDeepest(const VoxelGrid& grid, const CellShape& round);

/// The point of a solid voxel that is closest to a point, if any is within `halfExtent` cells.
struct ClosestVoxel {
    bool found = false;
    glm::ivec3 cell{0};
    glm::dvec3 point{0.0};
    double distance = 0.0;  ///< cells; 0 inside a voxel
};
ClosestVoxel findClosest(const VoxelGrid& grid, glm::dvec3 point, double halfExtent, EntryFilter accepted = nullptr);

/// Where a segment comes closest to a box: the points, and their distance, 0 if they meet.
struct SegmentToBox {
    glm::dvec3 onSegment, onBox;
    double distance;
};
SegmentToBox closestToBox(glm::dvec3 a, glm::dvec3 b, glm::dvec3 low, glm::dvec3 high);

}  // namespace rubble
