#include "runtime/voxel/write_box.h"

#include <gtest/gtest.h>

#include <vector>

#include "runtime/core/random.h"

namespace rubble {
namespace {

constexpr int kSide = 20;

/// Paint of a cell; 0 without.
uint8_t paintOf(const VoxelGrid& grid, glm::ivec3 cell) {
    const Brick* brick = grid.brickAt(brickOfCell(cell));
    return brick ? brick->paintAt(voxelIndex(cellInBrick(cell))) : uint8_t(0);
}

VoxelGrid randomGridOfRandomSize(Random& random) {
    VoxelGrid grid({kSide, kSide, kSide});
    GridWriter writer(grid);
    for (int i = 0; i < kSide * kSide * kSide; ++i)
        writer.set({i % kSide, i / kSide % kSide, i / kSide / kSide}, uint8_t(random.below(4)),
                   uint8_t(random.below(3) ? 0 : 16 + random.below(200)));
    writer.flush();
    return grid;
}

TEST(WrittenBrick, IsWhatWritingCellByCellMakes) {
    Random random(11);
    for (int i = 0; i < 60; ++i) {
        VoxelGrid grid = randomGridOfRandomSize(random), expected = grid;
        CellBox box;
        for (int a = 0; a < 3; ++a) {
            box.low[a] = random.between(0, kSide - 1);
            box.high[a] = random.between(box.low[a] + 1, kSide);
        }
        const glm::ivec3 size = box.high - box.low, from = brickOfCell(box.low), to = brickOfCell(box.high - 1);
        std::vector<uint8_t> indices(size_t(size.x * size.y * size.z));
        for (uint8_t& index : indices) index = uint8_t(random.below(4));
        {
            GridWriter writer(expected);
            for (size_t at = 0; at < indices.size(); ++at) {
                const int n = int(at);
                const glm::ivec3 cell = box.low + glm::ivec3(n % size.x, n / size.x % size.y, n / size.x / size.y);
                if (grid.at(cell) != indices[at]) writer.set(cell, indices[at]);
            }
        }
        const VoxelGrid before = grid;
        for (int z = from.z; z <= to.z; ++z)
            for (int y = from.y; y <= to.y; ++y)
                for (int x = from.x; x <= to.x; ++x) {
                    const BrickWrite write = writtenBrick(grid, {x, y, z}, box, indices);
                    if (write.any()) grid.setBrick({x, y, z}, write.after);
                    forEachVoxel(write.changed, [&](int voxel) {
                        const glm::ivec3 cell = glm::ivec3(x, y, z) * kBrickSize + voxelInBrick(voxel);
                        EXPECT_NE(before.at(cell), expected.at(cell));
                        EXPECT_EQ(hasVoxel(write.lost(), voxel), before.at(cell) != 0);
                        EXPECT_EQ(hasVoxel(write.made(), voxel), expected.at(cell) != 0);
                    });
                }
        EXPECT_EQ(grid.contentHash(), expected.contentHash());
        for (int n = 0; n < kSide * kSide * kSide; ++n) {
            const glm::ivec3 cell(n % kSide, n / kSide % kSide, n / kSide / kSide);
            ASSERT_EQ(grid.at(cell), expected.at(cell));
            ASSERT_EQ(paintOf(grid, cell), paintOf(expected, cell));
        }
    }
}

}  // namespace
}  // namespace rubble
