#include "runtime/voxel/brick.h"

#include <algorithm>
#include <cstring>

#include "runtime/core/byte_bits.h"
#include "runtime/core/hash.h"
#include "runtime/voxel/paint_colors.h"

namespace rubble {
namespace {

uint64_t loadRow(const BrickIndices& indices, size_t row) {
    return loadBytes(indices.data() + 8 * row);
}

void storeRow(BrickIndices& indices, size_t row, uint64_t value) {
    std::memcpy(indices.data() + 8 * row, &value, 8);
}

/// The paint of the solid voxels; null if none of them is painted.
std::unique_ptr<BrickIndices> paintOf(const BrickBits& solid, const BrickIndices& paint) {
    auto out = std::make_unique<BrickIndices>();
    uint64_t any = 0;
    for (size_t row = 0; row < 64; ++row) {
        const uint64_t kept = loadRow(paint, row) & spreadBits(solid[row / 8] >> 8 * (row % 8)) * 0xff;
        storeRow(*out, row, kept);
        any |= kept;
    }
    return any ? std::move(out) : nullptr;
}

/// The indices of the `solid` voxels (at least one), zero elsewhere. Null if all are the same: then it is `uniform`.
std::unique_ptr<BrickIndices> maskIndices(const BrickIndices& indices, const BrickBits& solid, uint8_t& uniform) {
    std::unique_ptr<BrickIndices> out(new BrickIndices);  // all of it is written below
    uint64_t first = 0, others = 0;  // the first index in all eight bytes; the bits in which others differ from it
    for (size_t row = 0; row < 64; ++row) {
        const uint64_t bits = solid[row / 8] >> 8 * (row % 8) & 0xff;
        const uint64_t cells = spreadBits(bits) * 0xff;
        const uint64_t kept = loadRow(indices, row) & cells;
        storeRow(*out, row, kept);
        if (!first && bits) first = (kept >> 8 * std::countr_zero(bits) & 0xff) * kByteOnes;
        others |= kept ^ (first & cells);
    }
    if (others) return out;
    uniform = uint8_t(first);
    return nullptr;
}

}  // namespace

void expandBrick(const Brick* brick, BrickIndices& out) {
    if (!brick)
        out.fill(0);
    else if (brick->indices)
        out = *brick->indices;
    else
        for (size_t row = 0; row < 64; ++row)
            storeRow(out, row, spreadBits(brick->occupancy[row / 8] >> 8 * (row % 8)) * brick->uniform);
}

BrickRef makeBrick(const BrickIndices& indices, const BrickIndices* paint) {
    auto brick = std::make_shared<Brick>();
    bool isUniform = true;
    for (size_t row = 0; row < 64; ++row) {
        const uint64_t values = loadRow(indices, row);
        if (!values) continue;
        const uint64_t solid = nonZeroBytes(values);
        brick->occupancy[row / 8] |= gatherBits(solid) << 8 * (row % 8);
        if (!brick->uniform) brick->uniform = uint8_t(values >> (std::countr_zero(solid)));
        isUniform = isUniform && values == solid * brick->uniform;
    }
    if (!brick->uniform) return nullptr;
    if (!isUniform) {
        brick->indices = std::make_unique<BrickIndices>(indices);
        brick->uniform = 0;
    }
    if (paint) brick->paint = paintOf(brick->occupancy, *paint);
    return brick;
}

BrickRef maskBrick(const Brick& brick, const BrickBits& keep) {
    BrickBits kept;
    for (size_t z = 0; z < 8; ++z) kept[z] = brick.occupancy[z] & keep[z];
    if (kept == BrickBits{}) return nullptr;
    auto out = std::make_shared<Brick>();
    out->occupancy = kept;
    out->uniform = brick.uniform;
    if (brick.indices) out->indices = maskIndices(*brick.indices, kept, out->uniform);
    if (brick.paint) out->paint = paintOf(kept, *brick.paint);
    return out;
}

int highestPaintColor(const Brick& brick) {
    int highest = 0;
    if (brick.paint)
        for (const uint8_t paint : *brick.paint)
            highest = std::max(highest, paint > 0 && paint < 16 ? kPaintColors + 1 : paintColor(paint));
    return highest;
}

uint64_t hashBrick(const Brick& brick) {
    uint64_t hash = brick.cachedHash.load(std::memory_order_relaxed);
    if (hash) return hash;
    if (brick.indices) {
        hash = hashBytes(brick.indices->data(), kBrickVoxels);
    } else {
        BrickIndices indices;
        expandBrick(&brick, indices);
        hash = hashBytes(indices.data(), kBrickVoxels);
    }
    if (brick.paint) hash = hashBytes(brick.paint->data(), brick.paint->size(), hash);
    brick.cachedHash.store(hash, std::memory_order_relaxed);
    return hash;
}

}  // namespace rubble
