#include "runtime/voxel/brick_parts.h"

namespace rubble {
namespace {

constexpr size_t kMaxCachedParts = 16;  ///< 112 bytes each: noise would cost far more than its voxels

constexpr uint64_t kFirstColumn = 0x0101010101010101ull;  ///< x = 0 in every row of a word
constexpr uint64_t kLastColumn = kFirstColumn << 7;

/// All cells of `open` that the seeds reach within one layer.
uint64_t fillLayer(uint64_t seeds, uint64_t open) {
    for (;;) {
        uint64_t grown = seeds;
        grown |= (grown << 1 & ~kFirstColumn) | (grown >> 1 & ~kLastColumn);
        grown &= open;
        grown |= grown << 8 | grown >> 8;
        grown &= open;
        if (grown == seeds || grown == open) return grown;
        seeds = grown;
    }
}

/// All cells of `open` that the seeds reach: sweeps up and down until one finds nothing to grow, or nothing is left to
/// grow into.
void fillBrick(BrickBits& seeds, const BrickBits& open) {
    const auto grow = [&](size_t z) {
        uint64_t from = seeds[z];
        if (z > 0) from |= seeds[z - 1];
        if (z < 7) from |= seeds[z + 1];
        from &= open[z];
        if (from == seeds[z]) return false;
        seeds[z] = fillLayer(from, open[z]);
        return true;
    };
    for (bool isUp = true;; isUp = !isUp) {
        bool hasGrown = false;
        uint64_t left = 0;
        for (size_t i = 0; i < 8; ++i) {
            const size_t z = isUp ? i : 7 - i;
            hasGrown |= grow(z);
            left |= seeds[z] ^ open[z];
        }
        if (!hasGrown || !left) return;
    }
}

/// The run along x that begins with the lowest cell of a layer.
uint64_t lowestRun(uint64_t layer) {
    const uint64_t first = layer & -layer, row = 0xffull << (std::countr_zero(layer) & ~7);
    return layer & ~(layer + first) & row;
}

/// Column x = 0 of a layer as eight bits.
uint64_t gatherColumn(uint64_t layer) {
    return (layer & kFirstColumn) * 0x0102040810204080ull >> 56;
}

void findFaces(BrickPart& part) {
    for (size_t z = 0; z < 8; ++z) {
        const uint64_t layer = part.voxels[z];
        part.faces[0] |= gatherColumn(layer) << 8 * z;
        part.faces[1] |= gatherColumn(layer >> 7) << 8 * z;
        part.faces[2] |= (layer & 0xff) << 8 * z;
        part.faces[3] |= (layer >> 56) << 8 * z;
    }
    part.faces[4] = part.voxels[0];
    part.faces[5] = part.voxels[7];
}

}  // namespace

void findBrickParts(const BrickBits& occupancy, std::vector<BrickPart>& out) {
    constexpr uint64_t kFull = ~uint64_t(0);
    constexpr BrickBits kFullBrick = {kFull, kFull, kFull, kFull, kFull, kFull, kFull, kFull};
    if (occupancy == kFullBrick) {
        out.push_back({kFullBrick, {kFull, kFull, kFull, kFull, kFull, kFull}});
        return;
    }
    BrickBits left = occupancy;
    for (size_t z = 0; z < 8; ++z)
        while (left[z]) {
            BrickPart& part = out.emplace_back();
            part.voxels[z] = fillLayer(lowestRun(left[z]), left[z]);
            fillBrick(part.voxels, left);
            findFaces(part);
            for (size_t i = z; i < 8; ++i) left[i] &= ~part.voxels[i];
        }
}

std::span<const BrickPart> brickParts(const Brick& brick, std::vector<BrickPart>& scratch) {
    static const std::vector<BrickPart> kFullBrick = [] {
        std::vector<BrickPart> out;
        findBrickParts({~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull}, out);
        return out;
    }();
    if (brick.full()) return kFullBrick;
    if (const auto* known = brick.cachedParts.find()) return *known;
    scratch.clear();
    findBrickParts(brick.occupancy, scratch);
    if (scratch.size() > kMaxCachedParts) return scratch;
    return brick.cachedParts.keep(std::make_unique<const std::vector<BrickPart>>(scratch.begin(), scratch.end()));
}

}  // namespace rubble
