#pragma once
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The solid cell in `range` whose centre is nearest to a point, all in cells; of equally near ones the first in the
/// order z, y, x. Only cells nearer than the root of `maxDistanceSquared` count. Costs the cells of the range.
std::optional<glm::ivec3> nearestVoxel(const VoxelGrid& grid, glm::dvec3 point, const CellBox& range,
                                       double maxDistanceSquared = std::numeric_limits<double>::infinity());

/// Squared distance, in cells, from a point to the centre of the nearest voxel of a grid; infinite if it is empty.
/// Searches shells of directory nodes around the point until none can hold a nearer voxel.
double nearestVoxelSquared(const VoxelGrid& grid, glm::dvec3 point);

}  // namespace rubble
