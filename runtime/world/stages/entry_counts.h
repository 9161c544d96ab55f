#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "runtime/voxel/brick_entries.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// Number of voxels by palette entry; 0 is not counted.
using EntryCounts = std::array<uint64_t, 256>;

/// Adds the solid voxels among `voxels` of a brick.
inline void addEntries(const Brick& brick, const BrickBits& voxels, EntryCounts& counts) {
    forEachEntry(brick, voxels, [&](uint8_t entry, size_t, uint64_t bits) { counts[entry] += std::popcount(bits); });
}

/// Counts all voxels of a grid.
inline EntryCounts countEntries(const VoxelGrid& grid) {
    EntryCounts out{};
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) { addEntries(*brick, brick->occupancy, out); });
    return out;
}

}  // namespace rubble
