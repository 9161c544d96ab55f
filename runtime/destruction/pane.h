#pragma once
#include <functional>
#include <vector>

#include "runtime/destruction/components.h"

namespace rubble {

/// A pane of glass: the voxels that are face-connected to `cell` through voxels of the same kind, searched by brick
/// from the cell outward, until `limit` are found or the last brick exceeds it. Each brick occurs once.
/// `isOfPane(entry)`: whether a palette entry is of the kind.
std::vector<BrickSubset> findPane(const VoxelGrid& grid, glm::ivec3 cell,
                                  const std::function<bool(uint8_t entry)>& isOfPane, uint64_t limit);

}  // namespace rubble
