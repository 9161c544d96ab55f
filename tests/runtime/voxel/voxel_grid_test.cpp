#include "runtime/voxel/voxel_grid.h"

#include <gtest/gtest.h>

#include "runtime/core/random.h"

namespace rubble {
namespace {

TEST(VoxelGrid, HoldsWhatWasWritten) {
    const glm::ivec3 size(37, 21, 70);
    VoxelGrid grid(size);
    std::vector<uint8_t> plain(size_t(size.x) * size.y * size.z);
    Random random(1);
    for (int round = 0; round < 3; ++round) {
        GridWriter writer(grid);
        for (int i = 0; i < 5000; ++i) {
            const int x = random.between(0, size.x - 1), y = random.between(0, size.y - 1),
                      z = random.between(0, size.z - 1);
            const uint8_t value = uint8_t(random.below(3));
            writer.set({x, y, z}, value);
            plain[(size_t(z) * size.y + y) * size.x + x] = value;
        }
    }
    uint64_t count = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const uint8_t expected = plain[(size_t(z) * size.y + y) * size.x + x];
                ASSERT_EQ(grid.at({x, y, z}), expected) << x << " " << y << " " << z;
                count += expected != 0;
            }
    EXPECT_EQ(grid.voxelCount(), count);
    EXPECT_EQ(grid.at({-1, 0, 0}), 0);
    EXPECT_EQ(grid.at({0, 21, 0}), 0);
}

TEST(VoxelGrid, CopySharesBricksAndIsIndependent) {
    VoxelGrid grid({16, 16, 16});
    GridWriter(grid).set({3, 3, 3}, 7);
    const VoxelGrid copy = grid;
    EXPECT_EQ(copy.brickAt({0, 0, 0}), grid.brickAt({0, 0, 0}));
    EXPECT_EQ(copy.contentHash(), grid.contentHash());
    GridWriter(grid).set({3, 3, 3}, 0);
    EXPECT_EQ(copy.at({3, 3, 3}), 7);
    EXPECT_TRUE(grid.empty());
    EXPECT_EQ(grid.contentHash(), 0u);
    EXPECT_EQ(grid.brickCount(), 0u);
}

TEST(VoxelGrid, EmptyWorldSizedGridCostsItsDirectoryOnly) {
    VoxelGrid grid({2048, 2048, 2048});
    EXPECT_LE(grid.memoryBytes(), size_t(64 * 64 * 64 * 8));
    GridWriter(grid).set({2047, 2047, 2047}, 1);
    EXPECT_EQ(grid.at({2047, 2047, 2047}), 1);
    EXPECT_EQ(grid.brickCount(), 1u);
}

TEST(VoxelGrid, CopyDiffersOnlyWhereOneWasWritten) {
    VoxelGrid grid({70, 70, 70});
    GridWriter(grid).set({1, 1, 1}, 7);
    GridWriter(grid).set({69, 1, 1}, 7);
    GridWriter(grid).set({69, 69, 69}, 7);
    const VoxelGrid before = grid;
    std::vector<glm::ivec3> bricks;
    const auto note = [&](glm::ivec3 brick) { bricks.push_back(brick); };
    grid.forEachUnshared(before, note);
    EXPECT_TRUE(bricks.empty());
    GridWriter(grid).set({68, 1, 1}, 7);
    GridWriter(grid).set({1, 1, 1}, 0);
    GridWriter(grid).set({1, 40, 1}, 9);
    grid.forEachUnshared(before, note);
    const std::vector<glm::ivec3> expected = {{0, 0, 0}, {8, 0, 0}, {0, 5, 0}};
    EXPECT_EQ(bricks, expected);
    EXPECT_EQ(before.at({68, 1, 1}), 0);
    EXPECT_EQ(before.at({1, 1, 1}), 7);
}

}  // namespace
}  // namespace rubble
