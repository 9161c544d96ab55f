#include "runtime/voxel/merged_boxes.h"

#include <gtest/gtest.h>

#include "runtime/core/random.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

std::bitset<256> all() {
    return std::bitset<256>().set();
}

TEST(MergedBoxes, AreOneForABox) {
    const std::vector<CellBox> boxes = mergedBoxes(solidGrid({37, 20, 9}), all());
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_EQ(boxes[0], (CellBox{{0, 0, 0}, {37, 20, 9}}));
}

TEST(MergedBoxes, AreFewForAWallWithAWindow) {
    VoxelGrid wall = solidGrid({40, 30, 4});
    fillBox(wall, {{10, 10, 0}, {20, 18, 4}}, 0);
    EXPECT_EQ(mergedBoxes(wall, all()).size(), 4u);
}

TEST(MergedBoxes, LeaveOutOtherEntriesAndEmptyGrids) {
    VoxelGrid grid = solidGrid({16, 16, 16}, 1);
    fillBox(grid, {{4, 0, 0}, {16, 16, 16}}, 2);
    const std::vector<CellBox> boxes = mergedBoxes(grid, std::bitset<256>().set(1));
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_EQ(boxes[0], (CellBox{{0, 0, 0}, {4, 16, 16}}));
    EXPECT_TRUE(mergedBoxes(VoxelGrid({8, 8, 8}), all()).empty());
}

/// Random grids, dense and sparse, with bricks that are missing.
TEST(MergedBoxes, HoldEachVoxelOnceAndNothingElse) {
    Random random(3);
    for (int round = 0; round < 60; ++round) {
        const glm::ivec3 size(random.between(1, 40), random.between(1, 30), random.between(1, 30));
        const int density = random.between(1, 20);
        const VoxelGrid grid = gridOf(size, [&](glm::ivec3 cell) {
            const bool isMissing = (cell.x / 8 + cell.y / 8 + cell.z / 8 + round) % 3 == 0;
            return uint8_t(isMissing || random.below(21) < uint32_t(density) ? 0 : 1 + random.below(2));
        });
        std::vector<int> covered(size_t(size.x * size.y * size.z));
        const auto at = [&](glm::ivec3 c) -> int& { return covered[size_t(c.x + size.x * (c.y + size.y * c.z))]; };
        for (const CellBox& box : mergedBoxes(grid, std::bitset<256>().set(2)))
            for (int z = box.low.z; z < box.high.z; ++z)
                for (int y = box.low.y; y < box.high.y; ++y)
                    for (int x = box.low.x; x < box.high.x; ++x) ++at({x, y, z});
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    ASSERT_EQ(at({x, y, z}), grid.at({x, y, z}) == 2) << round << ": " << x << " " << y << " " << z;
    }
}

}  // namespace
}  // namespace rubble
