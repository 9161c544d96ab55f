#include "runtime/voxel/brick.h"

#include "runtime/core/hash.h"

namespace rubble {

void expandBrick(const Brick* brick, BrickIndices& out) {
    out.fill(0);
    if (!brick) return;
    if (brick->indices)
        out = *brick->indices;
    else
        forEachVoxel(brick->occupancy, [&](int i) { out[i] = brick->uniform; });
}

BrickRef makeBrick(const BrickIndices& indices) {
    auto brick = std::make_shared<Brick>();
    bool isUniform = true;
    for (int i = 0; i < kBrickVoxels; ++i) {
        const uint8_t value = indices[i];
        if (!value) continue;
        brick->occupancy[i >> 6] |= uint64_t(1) << (i & 63);
        if (!brick->uniform) brick->uniform = value;
        isUniform = isUniform && value == brick->uniform;
    }
    if (!brick->uniform) return nullptr;
    if (!isUniform) {
        brick->indices = std::make_unique<BrickIndices>(indices);
        brick->uniform = 0;
    }
    return brick;
}

BrickRef maskBrick(const Brick& brick, const std::array<uint64_t, 8>& keep) {
    BrickIndices indices;
    expandBrick(&brick, indices);
    for (int i = 0; i < kBrickVoxels; ++i)
        if (!(keep[i >> 6] >> (i & 63) & 1)) indices[i] = 0;
    return makeBrick(indices);
}

uint64_t hashBrick(const Brick& brick) {
    BrickIndices indices;
    expandBrick(&brick, indices);
    return hashBytes(indices.data(), indices.size());
}

}  // namespace rubble
