#pragma once
#include <cstdint>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// What componentSizes() says, without parts of bricks, for noise: the bricks' bits, eight planes at a time, as rows across the
/// grid (see RunSets); cells without a neighbour are counted, not labelled.
std::vector<uint64_t> sizesByRuns(const VoxelGrid& grid);

}  // namespace rubble
