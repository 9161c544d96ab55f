#include "runtime/destruction/components.h"

#include <gtest/gtest.h>

#include "tests/runtime/destruction/reference_algorithms.h"

namespace rubble {
namespace {

void expectFloodFill(const VoxelGrid& grid) {
    const test::PlainGrid plain(grid);
    const auto expected = test::floodFill(plain);
    const auto found = findComponents(grid);
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(test::cellsOf(found[i], grid, plain), expected[i]) << "component " << i;
        EXPECT_EQ(found[i].voxels, expected[i].size());
        EXPECT_EQ(plain.index(found[i].lowest), expected[i].front());
    }
}

TEST(Components, EqualAFloodFillOfNoiseOfEveryDensity) {
    for (int percent : {0, 1, 5, 20, 31, 40, 60, 90, 100})
        for (const glm::ivec3 size : {glm::ivec3(8), glm::ivec3(37, 21, 19), glm::ivec3(33, 9, 70)}) {
            SCOPED_TRACE(testing::Message() << percent << " %, " << size.x << "x" << size.y << "x" << size.z);
            expectFloodFill(noiseGrid(size, percent, uint64_t(percent)));
        }
}

TEST(Components, FollowASnakeThroughOneBrick) {
    // Every other row and layer is solid, connected at alternating ends: the longest path in a brick.
    VoxelGrid grid(glm::ivec3(8));
    {
        GridWriter writer(grid);
        for (int z = 0; z < 8; z += 2)
            for (int y = 0; y < 8; y += 2) {
                for (int x = 0; x < 8; ++x) writer.set({x, y, z}, 1);
                writer.set({y / 2 % 2 ? 0 : 7, y + 1, z}, 1);
                writer.set({0, 7, z}, 0), writer.set({7, 7, z}, 0);
                if (y == 6 && z < 6) writer.set({z / 2 % 2 ? 0 : 7, z / 2 % 2 ? 0 : 6, z + 1}, 1);
            }
    }
    expectFloodFill(grid);
}

TEST(Components, OfACheckerboardAreItsVoxels) {
    VoxelGrid grid(glm::ivec3(16));
    {
        GridWriter writer(grid);
        for (int i = 0; i < 4096; ++i)
            if (const glm::ivec3 c(i & 15, i >> 4 & 15, i >> 8); (c.x + c.y + c.z) % 2) writer.set(c, 1);
    }
    EXPECT_EQ(findComponents(grid).size(), 2048u);
    expectFloodFill(grid);
}

}  // namespace
}  // namespace rubble
