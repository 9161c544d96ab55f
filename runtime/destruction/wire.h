#pragma once
#include <array>
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

using EntrySet = std::array<bool, 256>;

/// Whether a path of voxels of `wire`, face to face, leads from a cell to one that touches a voxel of `goal`. The cell
/// itself must be wire or goal. Costs the length of the wire.
bool isWireConnected(const VoxelGrid& grid, glm::ivec3 from, const EntrySet& wire, const EntrySet& goal);

}  // namespace rubble
