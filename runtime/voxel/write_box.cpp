#include "runtime/voxel/write_box.h"

#include <cstring>
#include <glm/common.hpp>

#include "runtime/core/byte_bits.h"

namespace rubble {
namespace {

/// One bit for each voxel: whether its byte differs.
BrickBits differentBits(const BrickIndices& a, const BrickIndices& b) {
    BrickBits out{};
    for (size_t row = 0; row < 64; ++row) {
        const uint64_t different = loadBytes(a.data() + 8 * row) ^ loadBytes(b.data() + 8 * row);
        out[row / 8] |= gatherBits(nonZeroBytes(different)) << 8 * (row % 8);
    }
    return out;
}

}  // namespace

BrickWrite writtenBrick(const VoxelGrid& grid, glm::ivec3 brick, const CellBox& box, std::span<const uint8_t> indices,
                        std::span<const uint8_t> mask) {
    BrickWrite out{.before = grid.shareBrick(brick)};
    BrickIndices was, is;
    expandBrick(out.before.get(), was);
    is = was;
    const glm::ivec3 size = box.high - box.low, corner = brick * kBrickSize;
    const glm::ivec3 low = glm::max(box.low, corner), high = glm::min(box.high, corner + kBrickSize);
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y) {
            const glm::ivec3 from = glm::ivec3(low.x, y, z) - box.low;
            const size_t at = (size_t(from.z) * size_t(size.y) + size_t(from.y)) * size_t(size.x) + size_t(from.x);
            uint8_t* row = is.data() + voxelIndex(glm::ivec3(low.x, y, z) - corner);
            const size_t cells = size_t(high.x - low.x);
            if (mask.empty())
                std::memcpy(row, indices.data() + at, cells);
            else
                for (size_t x = 0; x < cells; ++x) row[x] = mask[at + x] ? indices[at + x] : row[x];
        }
    out.changed = differentBits(was, is);
    if (!out.any()) return out;
    if (!out.before || !out.before->paint) {
        out.after = makeBrick(is);
        return out;
    }
    BrickIndices paint = *out.before->paint;
    forEachVoxel(out.changed, [&](int i) { paint[size_t(i)] = 0; });
    out.after = makeBrick(is, &paint);
    return out;
}

}  // namespace rubble
