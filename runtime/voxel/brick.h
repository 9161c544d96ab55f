#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "runtime/core/lazy.h"

namespace rubble {

inline constexpr int kBrickSize = 8;  ///< voxels on a side: OpenVDB's leaf size
inline constexpr int kBrickVoxels = kBrickSize * kBrickSize * kBrickSize;

/// Position of a voxel inside its brick: x + 8 y + 64 z.
constexpr int voxelIndex(glm::ivec3 inBrick) {
    return inBrick.x + inBrick.y * 8 + inBrick.z * 64;
}
constexpr glm::ivec3 voxelInBrick(int index) {
    return {index & 7, index >> 3 & 7, index >> 6};
}

/// One bit a voxel of a brick: word z, bit x + 8 y.
using BrickBits = std::array<uint64_t, 8>;

/// A byte for each voxel of a brick.
using BrickIndices = std::array<uint8_t, kBrickVoxels>;

/// A 6-connected component of the voxels of one brick, and where it reaches the brick's faces.
struct BrickPart {
    BrickBits voxels{};
    std::array<uint64_t, 6> faces{};  ///< -x +x -y +y -z +z: one bit a cell; facing faces have the same bit order
};

/// 8x8x8 voxels: a palette index each, 0 = empty. Never changed once a grid holds it: pieces, replicas, undo and
/// snapshots share it by reference. A brick of one index stores no index array; one without paint no paint.
struct Brick {
    std::array<uint64_t, 8> occupancy{};    ///< word z, bit x + 8 y
    std::unique_ptr<BrickIndices> indices;  ///< null if every solid voxel has `uniform`
    std::unique_ptr<BrickIndices> paint;    ///< the paint layer (see paint_colors.h); null if no voxel is painted
    uint8_t uniform = 0;
    // What follows from the voxels, worked out when first asked for. Bricks are shared by threads, and so is this.
    mutable std::atomic<uint16_t> cachedCount = 0;
    mutable std::atomic<uint64_t> cachedHash = 0;      ///< see hashBrick()
    mutable Lazy<std::vector<BrickPart>> cachedParts;  ///< see brickParts()

    bool solid(int index) const { return occupancy[index >> 6] >> (index & 63) & 1; }
    uint8_t at(int index) const { return !solid(index) ? uint8_t(0) : indices ? (*indices)[index] : uniform; }
    uint8_t at(glm::ivec3 inBrick) const { return at(voxelIndex(inBrick)); }
    uint8_t paintAt(int index) const { return paint ? (*paint)[index] : uint8_t(0); }
    int count() const {
        const int known = cachedCount.load(std::memory_order_relaxed);
        if (known) return known;
        int sum = 0;
        for (uint64_t word : occupancy) sum += std::popcount(word);
        cachedCount.store(uint16_t(sum), std::memory_order_relaxed);
        return sum;
    }
    bool full() const { return count() == kBrickVoxels; }
};

using BrickRef = std::shared_ptr<const Brick>;

/// All 512 indices of a brick; zeros for nullptr.
void expandBrick(const Brick* brick, BrickIndices& out);
/// A brick with these indices, uniform if they allow it; nullptr if all are zero. `paint` may be null; what it says
/// about empty voxels is ignored.
BrickRef makeBrick(const BrickIndices& indices, const BrickIndices* paint = nullptr);
/// The same indices and paint wherever `keep` (laid out as occupancy) has a bit, empty elsewhere; nullptr if nothing is
/// left.
BrickRef maskBrick(const Brick& brick, const std::array<uint64_t, 8>& keep);
/// A hash of the content alone: equal for equal voxels however they are stored.
uint64_t hashBrick(const Brick& brick);
/// Calls f(index) for every set bit, in ascending order.
template <class F>
void forEachVoxel(const std::array<uint64_t, 8>& occupancy, F&& f) {
    for (int z = 0; z < 8; ++z)
        for (uint64_t word = occupancy[z]; word; word &= word - 1) f(z * 64 + std::countr_zero(word));
}

}  // namespace rubble
