#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "runtime/voxel/voxel_grid.h"

// New grids of `size` cells, each component in [1, kMaxGridSize].
namespace rubble {

/// A grid of these entries, one byte each cell: x fastest, then y, then z; 0: no voxel.
VoxelGrid gridOf(glm::ivec3 size, std::span<const uint8_t> entries);
/// A grid with a voxel of one entry in each cell. What lies inside is shared: the cost is that of its directory.
VoxelGrid solidBox(glm::ivec3 size, uint8_t entry);
/// The same with voxels only in cells whose centre lies in the ellipsoid that touches the grid's six sides: a ball if
/// they are equally long.
VoxelGrid solidEllipsoid(glm::ivec3 size, uint8_t entry);

}  // namespace rubble
