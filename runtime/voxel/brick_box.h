#pragma once
#include <glm/common.hpp>

#include "runtime/voxel/brick.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

/// The cells of a brick that lie in a box of cells of the grid.
inline BrickBits cellsInBox(glm::ivec3 brick, const CellBox& box) {
    BrickBits out{};
    const glm::ivec3 base = brick * kBrickSize;
    const glm::ivec3 low = glm::max(box.low, base) - base, high = glm::min(box.high, base + kBrickSize) - base;
    if (CellBox{low, high}.empty()) return out;
    const uint64_t row = (uint64_t(1) << high.x) - (uint64_t(1) << low.x);
    uint64_t layer = 0;
    for (int y = low.y; y < high.y; ++y) layer |= row << 8 * y;
    for (int z = low.z; z < high.z; ++z) out[size_t(z)] = layer;
    return out;
}

}  // namespace rubble
