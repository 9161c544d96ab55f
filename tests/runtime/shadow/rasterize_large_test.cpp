#include "runtime/shadow/rasterize_large.h"

#include <gtest/gtest.h>

#include "tests/runtime/shadow/received_volume.h"

namespace rubble {
namespace {

TEST(RasterizeLarge, SetsTheCellsThatRowsSet) {
    Random random(1);
    size_t set = 0, bricks = 0;
    for (int round = 0; round < 60; ++round) {
        const double voxelSize = 0.7 + 5.0 * double(random.unit());
        const glm::ivec3 size(random.between(1, 12), random.between(1, 12), random.between(1, 12));
        const VoxelGrid grid = gridOf(size, [&](glm::ivec3) { return uint8_t(random.below(3) != 0); });
        const glm::dquat rotation = round % 4 ? drawRotation(random) : glm::dquat(1, 0, 0, 0);
        const Pose pose{drawPoint(random, -300.0, 300.0), rotation};
        ShadowCellTransform transform;
        ASSERT_TRUE(transform.place(pose, voxelSize));
        ASSERT_TRUE(hasLargeVoxels(transform)) << voxelSize;
        const CellBox bounds = shadowBounds(pose, voxelSize, {glm::ivec3(0), size});
        for (int i = 0; i < 50; ++i) {
            CellBox box;
            for (int a = 0; a < 3; ++a) {
                box.low[a] = random.between(bounds.low[a] - 3, bounds.high[a]);
                box.high[a] = box.low[a] + random.between(1, kShadowBrickCells);
            }
            const glm::ivec3 corner = box.high - kShadowBrickCells;
            CellRows boxes{}, rows{};
            rasterizeLargeVoxels(grid, transform, box, corner, boxes);
            rasterizeByRows(grid, transform, box, corner, rows);
            EXPECT_EQ(boxes, rows) << "round " << round << ", box " << i;
            for (const uint16_t row : rows) set += size_t(std::popcount(row));
            ++bricks;
        }
    }
    EXPECT_GT(set, 100 * bricks);
}

TEST(RasterizeLarge, SmallVoxelsGoByRows) {
    ShadowCellTransform transform;
    for (const double voxelSize : {0.02, 0.1, 0.3}) {
        ASSERT_TRUE(transform.place({}, voxelSize));
        EXPECT_FALSE(hasLargeVoxels(transform)) << voxelSize;
    }
}

}  // namespace
}  // namespace rubble
