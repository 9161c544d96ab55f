#include "runtime/destruction/carve.h"

#include <gtest/gtest.h>

#include "tests/runtime/destruction/reference_algorithms.h"

namespace rubble {
namespace {

VoxelGrid mixedGrid(glm::ivec3 size, uint64_t seed) {
    Random random(seed);
    return gridOf(size, [&](glm::ivec3) { return uint8_t(random.below(6)); });
}

TEST(Carve, RemovesEachClassWithinItsOwnRadius) {
    const Palette palette = test::fiveEntries();
    const MaterialTable materials = test::fiveMaterials();
    const VoxelGrid before = mixedGrid({40, 33, 29}, 5);
    VoxelGrid grid = before;
    const Brush brush = sphereBrush({19.3, 15.8, 14.1}, {11.0, 7.5, 3.2});
    CarveResult carved;
    carve(grid, brush, palette, materials, carved);
    const test::PlainGrid was(before), now(grid);
    std::array<uint64_t, 256> removed{};
    for (size_t i = 0; i < was.cells.size(); ++i) {
        const glm::ivec3 cell = was.cell(i);
        const uint8_t entry = was.cells[i];
        const std::array<int64_t, 3> center = {cell.x * 256 + 128, cell.y * 256 + 128, cell.z * 256 + 128};
        const bool goes = entry >= 1 && entry <= 3 && brushContains(brush, center, brush.radii[size_t(entry - 1)]);
        ASSERT_EQ(now.cells[i], goes ? 0 : entry);
        removed[entry] += goes;
    }
    EXPECT_EQ(carved.removed, removed);
    EXPECT_EQ(carved.voxels, before.voxelCount() - grid.voxelCount());
    EXPECT_GT(removed[1], removed[2]);
    EXPECT_GT(removed[3], 0u);
    EXPECT_EQ(removed[4] + removed[5], 0u);
}

TEST(Carve, MomentsOfTheRestAndOfRemovedVoxelsAddUp) {
    const Palette palette = test::fiveEntries();
    const MaterialTable materials = test::fiveMaterials();
    VoxelGrid grid = mixedGrid({70, 20, 45}, 6);
    const MassMoments all = gridMoments(grid, palette, materials);
    Random random(2);
    CarveResult carved;
    for (int i = 0; i < 40; ++i) {
        const double x = 70.0 * random.unit(), y = 20.0 * random.unit(), z = 45.0 * random.unit();
        carve(grid, capsuleBrush({x, y, z}, {y, z, x}, {4, 3, 2}), palette, materials, carved);
    }
    MassMoments sum = gridMoments(grid, palette, materials);
    EXPECT_NE(sum, all);
    sum += carved.moments;
    EXPECT_EQ(sum, all);
}

TEST(Carve, CachedValuesOfNodesEqualThoseOfANewGrid) {
    const Palette palette = test::fiveEntries();
    const MaterialTable materials = test::fiveMaterials();
    VoxelGrid grid = mixedGrid({70, 40, 45}, 8);
    gridMoments(grid, palette, materials);  // computes and caches the moments of all nodes
    Random random(3);
    for (int i = 0; i < 30; ++i) {
        CarveResult carved;
        const double x = 70.0 * random.unit(), y = 40.0 * random.unit(), z = 45.0 * random.unit();
        carve(grid, boxBrush({x, y, z}, {z / 9, x / 9, y / 9}, {1, 0, 0, 0}, Hardness::Medium), palette, materials,
              carved);
        VoxelGrid fresh(grid.size());
        BrickIndices indices;
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            expandBrick(brick.get(), indices);
            const BrickRef same = makeBrick(indices);
            ASSERT_EQ(bool(same->indices), bool(brick->indices));
            fresh.setBrick(position, same);
        });
        ASSERT_EQ(fresh.contentHash(), grid.contentHash());
        ASSERT_EQ(gridMoments(fresh, palette, materials), gridMoments(grid, palette, materials));
    }
}

TEST(Carve, ListsExactlyTheBricksThatChanged) {
    const VoxelGrid before = mixedGrid({64, 64, 64}, 7);
    VoxelGrid grid = before;
    CarveResult carved;
    carve(grid, boxBrush({30, 30, 30}, {9, 9, 9}, glm::normalize(glm::dquat(1, 0.3, 0.2, 0.1)), Hardness::Medium),
          test::fiveEntries(), test::fiveMaterials(), carved);
    EXPECT_EQ(carved.removed[3], 0u);
    EXPECT_GT(carved.removed[2], 0u);
    size_t changed = 0;
    before.forEachBrick(
        [&](glm::ivec3 position, const BrickRef& brick) { changed += brick.get() != grid.brickAt(position); });
    EXPECT_EQ(changed, carved.bricks.size());
    for (const glm::ivec3 position : carved.bricks) EXPECT_NE(before.brickAt(position), grid.brickAt(position));
}

}  // namespace
}  // namespace rubble
