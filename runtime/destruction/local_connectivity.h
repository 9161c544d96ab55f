#pragma once
#include <span>

#include "runtime/destruction/brick_set.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

/// Whether all that borders on carved bricks still hangs together close by, through these bricks and their neighbours:
/// then the cut has taken nothing apart. False says nothing: what is apart here may meet farther away.
bool isLocallyConnected(const VoxelGrid& grid, const BrickSet& carved);

/// The same for a small cut, by a look at its cells alone: whether all that is solid around the box in which voxels
/// went hangs together there, and no anchor reaches into it.
bool isLocallyConnected(const VoxelGrid& grid, const CellBox& lost, std::span<const CellBox> anchors);

}  // namespace rubble
