#include "runtime/destruction/split.h"

#include <cassert>
#include <glm/common.hpp>

namespace rubble {
namespace {

/// The cells that hold the share, high end excluded.
CellBox shareBounds(const BrickShare& share) {
    uint64_t layers = 0;
    glm::ivec3 low(0, 0, 8), high(0);
    for (int z = 0; z < 8; ++z) {
        if (!share.voxels[size_t(z)]) continue;
        layers |= share.voxels[size_t(z)];
        low.z = std::min(low.z, z);
        high.z = z + 1;
    }
    uint64_t row = layers | layers >> 32;
    row |= row >> 16;
    row = (row | row >> 8) & 0xff;
    low.x = std::countr_zero(row);
    high.x = 64 - std::countl_zero(row);
    low.y = std::countr_zero(layers) / 8;
    high.y = (63 - std::countl_zero(layers)) / 8 + 1;
    return {share.brick * kBrickSize + low, share.brick * kBrickSize + high};
}

}  // namespace

Piece takePiece(VoxelGrid& grid, const Component& component) {
    assert(!component.shares.empty());
    CellBox bounds = shareBounds(component.shares.front());
    for (const BrickShare& share : component.shares) {
        const CellBox box = shareBounds(share);
        bounds = {glm::min(bounds.low, box.low), glm::max(bounds.high, box.high)};
    }
    Piece piece;
    const glm::ivec3 lowBrick = bounds.low >> 3;
    piece.offset = lowBrick * kBrickSize;
    piece.grid = VoxelGrid(bounds.high - piece.offset);
    for (const BrickShare& share : component.shares) {
        BrickRef brick = grid.shareBrick(share.brick);
        if (brick->occupancy == share.voxels) {
            grid.setBrick(share.brick, nullptr);
            piece.grid.setBrick(share.brick - lowBrick, std::move(brick));
            continue;
        }
        BrickBits rest;
        for (size_t z = 0; z < 8; ++z) rest[z] = brick->occupancy[z] & ~share.voxels[z];
        grid.setBrick(share.brick, maskBrick(*brick, rest));
        piece.grid.setBrick(share.brick - lowBrick, maskBrick(*brick, share.voxels));
    }
    return piece;
}

}  // namespace rubble
