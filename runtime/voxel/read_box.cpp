#include "runtime/voxel/read_box.h"

#include <algorithm>
#include <glm/common.hpp>

#include "runtime/core/assertion.h"

namespace rubble {
namespace {

/// The cells [low, high) of a row of a brick along x; `row`: the number of its voxel at x = 0.
void readRow(const Brick& brick, int row, int low, int high, CellByte what, uint8_t* out) {
    const BrickIndices* bytes = what == CellByte::Index ? brick.indices.get() : brick.paint.get();
    const unsigned solid = unsigned(brick.occupancy[size_t(row / 64)] >> (row % 64)) & 255u;
    if (solid == 255u) {
        if (bytes)
            std::copy(bytes->begin() + row + low, bytes->begin() + row + high, out);
        else
            std::fill(out, out + (high - low), what == CellByte::Index ? brick.uniform : uint8_t(0));
        return;
    }
    if (!solid) return;
    for (int x = low; x < high; ++x)
        if (solid >> x & 1u) out[x - low] = what == CellByte::Index ? brick.at(row + x) : brick.paintAt(row + x);
}

}  // namespace

void readBox(const VoxelGrid& grid, const CellBox& box, CellByte what, std::span<uint8_t> out) {
    const glm::ivec3 size = box.high - box.low;
    RUBBLE_ASSERT(!box.empty() && out.size() == size_t(size.x) * size_t(size.y) * size_t(size.z));
    std::fill(out.begin(), out.end(), uint8_t(0));
    const glm::ivec3 low = glm::max(box.low, glm::ivec3(0)), high = glm::min(box.high, grid.size());
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x;) {
                const int end = std::min((x / kBrickSize + 1) * kBrickSize, high.x);
                const Brick* brick = grid.brickAt(brickOfCell(glm::ivec3(x, y, z)));
                const int row = voxelIndex({0, y % kBrickSize, z % kBrickSize});
                const size_t at = (size_t(z - box.low.z) * size_t(size.y) + size_t(y - box.low.y)) * size_t(size.x) +
                                  size_t(x - box.low.x);
                if (brick)
                    readRow(*brick, row, x % kBrickSize, end - x / kBrickSize * kBrickSize, what, out.data() + at);
                x = end;
            }
}

}  // namespace rubble
