#pragma once
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The largest box that isConnectedInBox() looks into: a ball of radius 6 with a cell around it.
inline constexpr glm::ivec3 kMaxConnectivityBox(15, 16, 16);

/// Whether all solid cells in a box of a grid are one 6-connected component inside of it, by a flood over words of
/// bits; false also of a box that is too large.
bool isConnectedInBox(const VoxelGrid& grid, const CellBox& box);

}  // namespace rubble
