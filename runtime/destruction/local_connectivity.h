#pragma once
#include <span>

#include "runtime/destruction/brick_set.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

/// A conservative connectivity test near a cut. True: all voxels that border on the carved bricks are connected through
/// these bricks and their neighbours, so the cut has detached nothing. False: unknown; they may be connected farther
/// away.
bool isLocallyConnected(const VoxelGrid& grid, const BrickSet& carved);

/// The same test for a small cut, on cells alone. `lost`: the box of the removed voxels. True if the solid cells in and
/// around it are connected within one cell of it, and no anchor overlaps it.
bool isLocallyConnected(const VoxelGrid& grid, const CellBox& lost, std::span<const CellBox> anchors);

}  // namespace rubble
