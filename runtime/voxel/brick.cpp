#include "runtime/voxel/brick.h"

#include <cstring>

#include "runtime/core/hash.h"

namespace rubble {
namespace {

static_assert(std::endian::native == std::endian::little, "a row of eight indices is read as one word, cell x = 0 lowest");

constexpr uint64_t kOnes = 0x0101010101010101ull;

/// 1 in every byte that is not zero.
uint64_t nonZeroBytes(uint64_t row) {
    return (((row & 0x7f * kOnes) + 0x7f * kOnes) | row) >> 7 & kOnes;
}
/// Eight bytes of 0 or 1 as eight bits, and back.
uint64_t gatherBits(uint64_t ones) {
    return ones * 0x0102040810204080ull >> 56;
}
uint64_t spreadBits(uint64_t bits) {
    return nonZeroBytes((bits & 0xff) * kOnes & 0x8040201008040201ull);
}

uint64_t loadRow(const BrickIndices& indices, size_t row) {
    uint64_t out;
    std::memcpy(&out, indices.data() + 8 * row, 8);
    return out;
}

void storeRow(BrickIndices& indices, size_t row, uint64_t value) {
    std::memcpy(indices.data() + 8 * row, &value, 8);
}

/// The paint of the solid voxels among it; null if there is none.
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

}  // namespace

void expandBrick(const Brick* brick, BrickIndices& out) {
    if (!brick)
        out.fill(0);
    else if (brick->indices)
        out = *brick->indices;
    else
        for (size_t row = 0; row < 64; ++row) storeRow(out, row, spreadBits(brick->occupancy[row / 8] >> 8 * (row % 8)) * brick->uniform);
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

BrickRef maskBrick(const Brick& brick, const std::array<uint64_t, 8>& keep) {
    BrickIndices indices;
    expandBrick(&brick, indices);
    for (size_t row = 0; row < 64; ++row) storeRow(indices, row, loadRow(indices, row) & spreadBits(keep[row / 8] >> 8 * (row % 8)) * 0xff);
    return makeBrick(indices, brick.paint.get());
}

uint64_t hashBrick(const Brick& brick) {
    uint64_t hash = brick.knownHash.load(std::memory_order_relaxed);
    if (hash) return hash;
    BrickIndices indices;
    expandBrick(&brick, indices);
    hash = hashBytes(indices.data(), indices.size());
    if (brick.paint) hash = hashBytes(brick.paint->data(), brick.paint->size(), hash);
    brick.knownHash.store(hash, std::memory_order_relaxed);
    return hash;
}

}  // namespace rubble
