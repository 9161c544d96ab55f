#include "runtime/voxel/read_box.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "runtime/core/random.h"

namespace rubble {
namespace {

/// Some bricks are full of one index, some of many, some have holes, some are empty.
VoxelGrid mixedGrid() {
    VoxelGrid grid({29, 18, 21});
    Random random(5);
    GridWriter writer(grid);
    for (int z = 0; z < 21; ++z)
        for (int y = 0; y < 18; ++y)
            for (int x = 0; x < 29; ++x) {
                const int kind = (x / 8 + y / 8 * 2 + z / 8) % 4;
                if (kind == 0 || (kind == 1 && random.below(3) == 0)) continue;
                const auto index = uint8_t(kind == 2 ? 7 : 1 + random.below(255));
                writer.set({x, y, z}, index, uint8_t(kind == 3 ? random.below(256) : 0));
            }
    writer.flush();
    return grid;
}

TEST(ReadBox, GivesEveryCellOfAnyBox) {
    const VoxelGrid grid = mixedGrid();
    Random random(6);
    for (int i = 0; i < 200; ++i) {
        CellBox box;
        for (int a = 0; a < 3; ++a) {
            box.low[a] = random.between(-6, 30);
            box.high[a] = box.low[a] + random.between(1, 30);
        }
        const glm::ivec3 size = box.high - box.low;
        std::vector<uint8_t> indices(size_t(size.x * size.y * size.z), 99), paint = indices;
        readBox(grid, box, CellByte::Index, indices);
        readBox(grid, box, CellByte::Paint, paint);
        size_t at = 0;
        for (int z = box.low.z; z < box.high.z; ++z)
            for (int y = box.low.y; y < box.high.y; ++y)
                for (int x = box.low.x; x < box.high.x; ++x, ++at) {
                    const glm::ivec3 cell(x, y, z);
                    const bool isSolid = grid.at(cell) != 0;
                    ASSERT_EQ(indices[at], grid.at(cell)) << x << " " << y << " " << z;
                    const Brick* brick = isSolid ? grid.brickAt(brickOfCell(cell)) : nullptr;
                    ASSERT_EQ(paint[at], brick ? brick->paintAt(voxelIndex(cellInBrick(cell))) : 0);
                }
    }
}

TEST(CellAt, IsTheCellThatHoldsAPointAndAFarOneForFarPoints) {
    constexpr int kFarthest = 1000000000;
    EXPECT_EQ(cellAt({0.5, -0.5, 7.0}), glm::ivec3(0, -1, 7));
    EXPECT_EQ(cellAt({6e9, -1.2e10, 0.0}), glm::ivec3(kFarthest, -kFarthest, 0));
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(cellAt({infinity, -infinity, -std::numeric_limits<double>::quiet_NaN()}),
              glm::ivec3(kFarthest, -kFarthest, -kFarthest));
}

}  // namespace
}  // namespace rubble
