#pragma once
#include <array>
#include <cstdint>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// Number of voxels by palette entry; 0 is not counted.
using EntryCounts = std::array<uint64_t, 256>;

/// Counts all voxels of a grid; costs their number.
inline EntryCounts countEntries(const VoxelGrid& grid) {
    EntryCounts out{};
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) { ++out[brick->at(i)]; });
    });
    return out;
}

}  // namespace rubble
