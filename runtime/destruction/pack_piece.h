#pragma once
#include <span>

#include "runtime/destruction/components.h"
#include "runtime/destruction/split.h"

namespace rubble {

/// Copies voxels into a grid as small as they are: its offset is their lowest cell along each axis. For pieces of a few
/// hundred voxels, which would otherwise occupy up to eight bricks.
Piece packPiece(const VoxelGrid& grid, std::span<const BrickSubset> subsets);

}  // namespace rubble
