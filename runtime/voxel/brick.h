#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "runtime/core/lazy.h"

namespace rubble {

inline constexpr int kBrickSize = 8;  ///< voxels on a side, as an OpenVDB leaf node
inline constexpr int kBrickVoxels = kBrickSize * kBrickSize * kBrickSize;

/// The brick that holds a cell; along one axis, or all three.
constexpr int brickOfCell(int cell) {
    return cell >> 3;
}
/// The brick that holds a cell of the grid.
constexpr glm::ivec3 brickOfCell(glm::ivec3 cell) {
    return cell >> 3;
}
/// Position of a cell inside its brick along one axis, 0 to 7.
constexpr int cellInBrick(int cell) {
    return cell & 7;
}
/// Position of a cell inside its brick, each component 0 to 7.
constexpr glm::ivec3 cellInBrick(glm::ivec3 cell) {
    return cell & 7;
}
/// Number of a voxel in its brick: x + 8 y + 64 z of its position inside the brick.
constexpr int voxelIndex(glm::ivec3 inBrick) {
    return inBrick.x + inBrick.y * 8 + inBrick.z * 64;
}
/// The position inside the brick of the voxel with this number: the inverse of voxelIndex().
constexpr glm::ivec3 voxelInBrick(int index) {
    return {index & 7, index >> 3 & 7, index >> 6};
}

/// One bit for each voxel of a brick: word z, bit x + 8 y.
using BrickBits = std::array<uint64_t, 8>;

inline constexpr BrickBits kFullBrickBits = {~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull};
inline constexpr uint64_t kFirstColumn = 0x0101010101010101ull;  ///< x = 0 in every row of a layer
inline constexpr uint64_t kLastColumn = kFirstColumn << 7;       ///< x = 7 in every row of a layer

/// Whether the bit of voxel `index` is set.
constexpr bool hasVoxel(const BrickBits& bits, int index) {
    return bits[size_t(index >> 6)] >> (index & 63) & 1;
}
/// Sets the bit of voxel `index`.
constexpr void setVoxel(BrickBits& bits, int index) {
    bits[size_t(index >> 6)] |= uint64_t(1) << (index & 63);
}
/// Clears the bit of voxel `index`.
constexpr void clearVoxel(BrickBits& bits, int index) {
    bits[size_t(index >> 6)] &= ~(uint64_t(1) << (index & 63));
}

/// One byte for each voxel of a brick, by voxelIndex().
using BrickIndices = std::array<uint8_t, kBrickVoxels>;

/// A 6-connected component of the voxels of one brick, and its cells on the brick's faces.
struct BrickPart {
    BrickBits voxels{};
    /// By face, in the order -x +x -y +y -z +z: one bit for each cell of the face. Two faces that touch, of
    /// neighbouring bricks, number their cells alike, so an AND of the two finds contacts.
    std::array<uint64_t, 6> faces{};
};

/// 8x8x8 voxels, a palette index each; 0 is empty. Immutable once a grid holds it: grids, detached pieces, replicas,
/// undo and snapshots share it by reference. A brick of one index stores no index array; one without paint stores no
/// paint.
struct Brick {
    BrickBits occupancy{};                  ///< which voxels are solid
    std::unique_ptr<BrickIndices> indices;  ///< null if every solid voxel has the index `uniform`
    std::unique_ptr<BrickIndices> paint;    ///< the paint layer (paint_colors.h); null if no voxel is painted
    uint8_t uniform = 0;
    // Computed from the voxels on first use. Any thread may do that: all threads compute the same value.
    mutable std::atomic<uint16_t> cachedCount = 0;
    mutable std::atomic<uint64_t> cachedHash = 0;      ///< see hashBrick()
    mutable Lazy<std::vector<BrickPart>> cachedParts;  ///< see brickParts()

    /// Whether voxel `index` is solid.
    bool solid(int index) const { return hasVoxel(occupancy, index); }
    /// The palette index of voxel `index`; 0 if it is empty.
    uint8_t at(int index) const { return !solid(index) ? uint8_t(0) : indices ? (*indices)[index] : uniform; }
    /// The palette index at a position inside the brick; 0 if it is empty.
    uint8_t at(glm::ivec3 inBrick) const { return at(voxelIndex(inBrick)); }
    /// The paint byte of voxel `index` (paint_colors.h); 0 if it is not painted.
    uint8_t paintAt(int index) const { return paint ? (*paint)[index] : uint8_t(0); }
    /// [any-thread] Solid voxels.
    int count() const {
        const int known = cachedCount.load(std::memory_order_relaxed);
        if (known) return known;
        int sum = 0;
        for (uint64_t word : occupancy) sum += std::popcount(word);
        cachedCount.store(uint16_t(sum), std::memory_order_relaxed);
        return sum;
    }
    /// [any-thread] Whether no voxel is empty.
    bool full() const { return count() == kBrickVoxels; }
};

using BrickRef = std::shared_ptr<const Brick>;

/// Writes all 512 palette indices of a brick; zeros for nullptr.
void expandBrick(const Brick* brick, BrickIndices& out);
/// A brick with these indices, uniform if they allow it; nullptr if all are zero. `paint` may be null; its bytes at
/// empty voxels are ignored.
BrickRef makeBrick(const BrickIndices& indices, const BrickIndices* paint = nullptr);
/// A copy with the indices and paint of the voxels in `keep`, the others empty; nullptr if nothing is left.
BrickRef maskBrick(const Brick& brick, const BrickBits& keep);
/// The highest colour of a brick's paint (paint_colors.h), 0 without paint; more than kPaintColors if a byte is no
/// paint at all.
int highestPaintColor(const Brick& brick);
/// [any-thread] A hash of the content: equal voxels have equal hashes, stored as one index or as an array.
uint64_t hashBrick(const Brick& brick);
/// Calls f(index) for every set bit, in ascending order.
template <class F>
void forEachVoxel(const BrickBits& bits, F&& f) {
    for (int z = 0; z < 8; ++z)
        for (uint64_t word = bits[z]; word; word &= word - 1) f(z * 64 + std::countr_zero(word));
}

}  // namespace rubble
