#include "runtime/destruction/pack_piece.h"

#include <glm/common.hpp>
#include <vector>

#include "runtime/core/assertion.h"

namespace rubble {

Piece packPiece(const VoxelGrid& grid, std::span<const BrickSubset> subsets) {
    RUBBLE_ASSERT(!subsets.empty());
    glm::ivec3 low(kMaxGridSize), high(0);
    bool isPainted = false;
    for (const BrickSubset& subset : subsets) {
        isPainted = isPainted || grid.brickAt(subset.brick)->paint;
        forEachVoxel(subset.voxels, [&](int i) {
            const glm::ivec3 cell = subset.brick * kBrickSize + voxelInBrick(i);
            low = glm::min(low, cell);
            high = glm::max(high, cell + 1);
        });
    }
    Piece piece{VoxelGrid(high - low), low};
    const glm::ivec3 bricks = piece.grid.sizeInBricks();
    const size_t count = size_t(bricks.x) * bricks.y * bricks.z;
    std::vector<BrickIndices> indices(count), paint(isPainted ? count : 0);
    for (const BrickSubset& subset : subsets) {
        const Brick& from = *grid.brickAt(subset.brick);
        const glm::ivec3 shift = subset.brick * kBrickSize - low;
        forEachVoxel(subset.voxels, [&](int i) {
            const glm::ivec3 cell = voxelInBrick(i) + shift, brick = brickOfCell(cell);
            const size_t at = (size_t(brick.z) * bricks.y + brick.y) * bricks.x + brick.x;
            const size_t voxel = size_t(voxelIndex(cellInBrick(cell)));
            indices[at][voxel] = from.at(i);
            if (isPainted) paint[at][voxel] = from.paintAt(i);
        });
    }
    for (size_t i = 0; i < count; ++i) {
        const glm::ivec3 brick(int(i) % bricks.x, int(i) / bricks.x % bricks.y, int(i) / bricks.x / bricks.y);
        piece.grid.setBrick(brick, makeBrick(indices[i], isPainted ? &paint[i] : nullptr));
    }
    return piece;
}

}  // namespace rubble
