#pragma once
#include <cstdint>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// How many nodes the directories of all grids of a file may have together: 128 MiB of pointers, or 2^39 cells. A grid
/// of 4096^3 cells has 2^21 nodes. A short file with large grid sizes is refused before it takes the memory.
inline constexpr uint64_t kMaxDirectoryNodes = 1u << 24;

/// How many nodes the directory of a grid of this size has.
inline uint64_t directoryNodes(glm::ivec3 size) {
    const glm::ivec3 nodes = (size + (kNodeSize - 1)) / kNodeSize;
    return uint64_t(nodes.x) * uint64_t(nodes.y) * uint64_t(nodes.z);
}

}  // namespace rubble
