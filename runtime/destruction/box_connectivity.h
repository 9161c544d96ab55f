#pragma once
#include <glm/vec3.hpp>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The largest box that isConnectedInBox() tests: a ball of radius 6 with one cell around it.
inline constexpr glm::ivec3 kMaxConnectivityBox(15, 16, 16);

/// Whether the solid cells in a box of a grid are one 6-connected component without any cell outside the box. True for
/// an empty box; false for one that is larger than kMaxConnectivityBox.
bool isConnectedInBox(const VoxelGrid& grid, const CellBox& box);

}  // namespace rubble
