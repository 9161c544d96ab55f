#include "runtime/voxel/brick_parts.h"

#include "runtime/core/byte_bits.h"

// Connected components of one brick by flood fill on words of occupancy. A layer z of a brick is 64 bits, bit x + 8 y,
// so a shift by 1 moves all its cells along x, a shift by 8 along y, and the next word is the next layer: one step of
// the flood moves up to 64 cells at once. Masks of the first and last column stop cells that a shift by 1 would carry
// into the next row. A component begins with the lowest voxel that is not labelled yet; it floods its layer, then the
// layers up and down in sweeps until a sweep changes nothing.

namespace rubble {
namespace {

constexpr size_t kMaxCachedParts = 16;  ///< 112 bytes each: noise would cost far more than its voxels

/// All cells of `open` that are connected to the seeds within one layer.
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

/// All cells of `open` that are connected to the seeds. Stops when a sweep adds nothing, or when nothing is left to
/// add.
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
    return gatherBits(layer & kFirstColumn);
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
    if (occupancy == kFullBrickBits) {
        out.push_back({kFullBrickBits, {~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull}});
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

std::span<const BrickPart> fullBrickParts() {
    static const std::vector<BrickPart> kParts = [] {
        std::vector<BrickPart> out;
        findBrickParts(kFullBrickBits, out);
        return out;
    }();
    return kParts;
}

std::span<const BrickPart> brickParts(const Brick& brick, std::vector<BrickPart>& scratch) {
    if (brick.full()) return fullBrickParts();
    if (const auto* known = brick.cachedParts.find()) return *known;
    scratch.clear();
    findBrickParts(brick.occupancy, scratch);
    if (scratch.size() > kMaxCachedParts) return scratch;
    return brick.cachedParts.keep(std::make_unique<const std::vector<BrickPart>>(scratch.begin(), scratch.end()));
}

}  // namespace rubble
