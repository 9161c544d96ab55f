#include "runtime/destruction/split.h"

#include <gtest/gtest.h>

#include "tests/runtime/destruction/reference_algorithms.h"

namespace rubble {
namespace {

TEST(Split, PiecesHoldTheirCellsAndTheGridTheRest) {
    for (const int percent : {20, 30, 45}) {
        VoxelGrid grid = noiseGrid({45, 26, 33}, percent, 9);
        const test::PlainGrid before(grid);
        const auto components = findComponents(grid);
        uint64_t voxels = grid.voxelCount();
        for (size_t i = 0; i < components.size(); i += 2) {
            const std::vector<size_t> cells = test::cellsOf(components[i], grid, before);
            const Piece piece = takePiece(grid, components[i]);
            ASSERT_EQ(piece.offset % kBrickSize, glm::ivec3(0));
            ASSERT_EQ(piece.grid.voxelCount(), components[i].voxels);
            for (const size_t cell : cells) {
                ASSERT_EQ(piece.grid.at(before.cell(cell) - piece.offset), before.cells[cell]);
                ASSERT_EQ(grid.at(before.cell(cell)), 0);
            }
            voxels -= components[i].voxels;
            ASSERT_EQ(grid.voxelCount(), voxels);
        }
    }
}

TEST(Split, AWholeBrickIsSharedNotCopied) {
    VoxelGrid grid({40, 16, 16});
    {
        GridWriter writer(grid);
        for (int i = 0; i < 40 * 16 * 16; ++i)
            if (const glm::ivec3 c(i % 40, i / 40 % 16, i / 640); c.x != 12) writer.set(c, uint8_t(1 + c.y % 2));
    }
    const Brick* far = grid.brickAt({4, 1, 1});
    const auto components = findComponents(grid);
    ASSERT_EQ(components.size(), 2u);
    const Piece piece = takePiece(grid, components[1]);
    EXPECT_EQ(piece.offset, glm::ivec3(8, 0, 0));
    EXPECT_EQ(piece.grid.size(), glm::ivec3(32, 16, 16));
    EXPECT_EQ(piece.grid.brickAt({3, 1, 1}), far);
    EXPECT_EQ(piece.grid.at({5, 3, 3}), 2);
    EXPECT_EQ(piece.grid.at({3, 3, 3}), 0);
}

TEST(Split, APieceIsNoLargerThanItsCells) {
    VoxelGrid grid({40, 40, 40});
    GridWriter(grid).set({17, 30, 9}, 1);
    const Piece piece = takePiece(grid, findComponents(grid)[0]);
    EXPECT_EQ(piece.offset, glm::ivec3(16, 24, 8));
    EXPECT_EQ(piece.grid.size(), glm::ivec3(2, 7, 2));
    EXPECT_TRUE(grid.empty());
}

}  // namespace
}  // namespace rubble
