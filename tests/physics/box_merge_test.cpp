#include "tests/physics/baseline/box_merge.h"

#include <gtest/gtest.h>

#include "runtime/core/random.h"

namespace rubble {
namespace {

SolidEntries all() {
    return ~SolidEntries{};
}

/// Random blocks and random holes: large boxes, ragged edges, many bricks and regions.
VoxelGrid ragged(glm::ivec3 size, uint64_t seed) {
    VoxelGrid grid(size);
    GridWriter writer(grid);
    Random random(seed);
    for (int block = 0; block < 12; ++block) {
        glm::ivec3 low, high;
        for (int i = 0; i < 3; ++i) {
            low[i] = random.between(0, size[i] - 1);
            high[i] = std::min(size[i], low[i] + random.between(1, 24));
        }
        const uint8_t index = block % 3 ? uint8_t(1 + block % 2) : uint8_t(0);
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x) writer.set({x, y, z}, index);
    }
    for (int i = 0; i < 500; ++i) {
        const int x = random.between(0, size.x - 1), y = random.between(0, size.y - 1),
                  z = random.between(0, size.z - 1);
        const uint8_t index = uint8_t(random.below(3));
        writer.set({x, y, z}, index);
    }
    writer.flush();
    return grid;
}

/// Every solid cell is in exactly one box, and no empty cell is in one.
void expectExactCover(const VoxelGrid& grid, const SolidEntries& solid, const std::vector<CellBox>& boxes) {
    const glm::ivec3 size = grid.size();
    std::vector<uint8_t> covered(size_t(size.x) * size.y * size.z);
    for (const CellBox& box : boxes) {
        ASSERT_FALSE(box.empty());
        for (int z = box.low.z; z < box.high.z; ++z)
            for (int y = box.low.y; y < box.high.y; ++y)
                for (int x = box.low.x; x < box.high.x; ++x) {
                    ASSERT_TRUE(grid.contains({x, y, z}));
                    ++covered[(size_t(z) * size.y + y) * size.x + x];
                }
    }
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const uint8_t index = grid.at({x, y, z});
                ASSERT_EQ(covered[(size_t(z) * size.y + y) * size.x + x], index && solid[index] ? 1 : 0)
                    << x << " " << y << " " << z;
            }
}

TEST(BoxMerge, CoversExactlyAndDisjointly) {
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const VoxelGrid grid = ragged({70, 41, 33}, seed);
        expectExactCover(grid, all(), mergeGrid(grid, all()));
    }
}

TEST(BoxMerge, LeavesUnphysicalEntriesOut) {
    SolidEntries solid = all();
    solid[2] = false;
    const VoxelGrid grid = ragged({40, 40, 40}, 3);
    expectExactCover(grid, solid, mergeGrid(grid, solid));
}

TEST(BoxMerge, SolidBlockIsOneBoxAcrossBricksAndRegions) {
    VoxelGrid grid({100, 50, 40});
    {
        GridWriter writer(grid);
        for (int z = 3; z < 39; ++z)
            for (int y = 1; y < 47; ++y)
                for (int x = 5; x < 99; ++x) writer.set({x, y, z}, 1);
    }
    const std::vector<CellBox> boxes = mergeGrid(grid, all());
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_EQ(boxes[0], (CellBox{{5, 1, 3}, {99, 47, 39}}));
}

TEST(BoxMerge, SameVoxelsGiveSameBoxes) {
    const VoxelGrid grid = ragged({64, 64, 64}, 9);
    EXPECT_EQ(mergeGrid(grid, all()), mergeGrid(VoxelGrid(grid), all()));
}

TEST(BoxMerge, HalvingKeepsWhatIsHalfFull) {
    VoxelGrid grid({8, 8, 8});
    {
        GridWriter writer(grid);
        for (int z = 0; z < 8; ++z)
            for (int x = 0; x < 8; ++x) writer.set({x, 0, z}, 1);  // a plate one cell thick
        writer.set({4, 7, 4}, 1);                                  // a lone cell
    }
    const VoxelGrid half = halveGrid(grid, all());
    EXPECT_EQ(half.size(), glm::ivec3(4));
    EXPECT_EQ(half.voxelCount(), 16u);
    EXPECT_EQ(half.at({3, 0, 3}), 1);
    EXPECT_EQ(half.at({2, 3, 2}), 0);
}

}  // namespace
}  // namespace rubble
