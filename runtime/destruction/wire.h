#pragma once
#include <array>
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

using EntrySet = std::array<bool, 256>;  ///< by palette entry

/// Whether a path of face-connected voxels of `wire` leads from a cell to one that touches a voxel of `goal`. The first
/// cell must be of `wire` or `goal` itself. The cost grows with the length of the wire.
bool isWireConnected(const VoxelGrid& grid, glm::ivec3 from, const EntrySet& wire, const EntrySet& goal);

}  // namespace rubble
