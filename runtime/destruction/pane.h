#pragma once
#include <functional>
#include <vector>

#include "runtime/destruction/components.h"

namespace rubble {

/// The voxels that are connected by faces to a cell through voxels of the same kind, nearest bricks first, until there
/// are `limit` of them or a few more. Each brick once.
std::vector<BrickSubset> findPane(const VoxelGrid& grid, glm::ivec3 cell,
                                  const std::function<bool(uint8_t entry)>& isOfPane, uint64_t limit);

}  // namespace rubble
