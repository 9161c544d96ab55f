#pragma once
#include <cstdint>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// What componentSizes() says, without parts of bricks, for noise: the bricks' bits, eight planes at a time, as rows
/// across the grid (see RunLabels); cells without a neighbour are counted, not labelled.
std::vector<uint64_t> componentSizesByRuns(const VoxelGrid& grid);

}  // namespace rubble
