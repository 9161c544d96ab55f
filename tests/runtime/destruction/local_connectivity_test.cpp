#include "runtime/destruction/local_connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/destruction/carve.h"
#include "runtime/destruction/split.h"
#include "tests/runtime/destruction/reference_algorithms.h"

namespace rubble {
namespace {

CarveResult cut(VoxelGrid& grid, const Brush& brush) {
    CarveResult out;
    carve(grid, brush, test::fiveEntries(), test::fiveMaterials(), out);
    return out;
}

BrickSet carved(VoxelGrid& grid, const Brush& brush) {
    const CarveResult out = cut(grid, brush);
    BrickSet bricks;
    for (const glm::ivec3 brick : out.bricks) bricks.insert(brick);
    return bricks;
}

VoxelGrid wall() {
    return solidGrid({80, 80, 6});
}

TEST(LocalConnectivity, AHoleInAWallDetachesNothing) {
    VoxelGrid grid = wall();
    EXPECT_TRUE(isLocallyConnected(grid, carved(grid, sphereBrush({37, 44, 3}, {6, 6, 6}))));
}

TEST(LocalConnectivity, TheBoxTestIsEnoughForASmallHole) {
    VoxelGrid grid = wall();
    const CarveResult hole = cut(grid, sphereBrush({37, 44, 3}, {6, 6, 6}));
    EXPECT_EQ(hole.cells, (CellBox{{31, 38, 0}, {43, 50, 6}}));
    EXPECT_TRUE(isLocallyConnected(grid, hole.cells, {}));
    const std::array<CellBox, 1> beside{{{{0, 0, 0}, {31, 80, 6}}}}, inside{{{{0, 0, 0}, {32, 80, 6}}}};
    EXPECT_TRUE(isLocallyConnected(grid, hole.cells, beside));
    EXPECT_FALSE(isLocallyConnected(grid, hole.cells, inside));
    EXPECT_FALSE(isLocallyConnected(
        grid, cut(grid, boxBrush({40, 40, 3}, {34, 34, 9}, {1, 0, 0, 0}, Hardness::Hard)).cells, {}));
}

TEST(LocalConnectivity, DoesNotSeeConnectionsFarAway) {
    VoxelGrid ring = wall();
    carved(ring, boxBrush({40, 40, 3}, {34, 34, 9}, {1, 0, 0, 0}, Hardness::Hard));
    EXPECT_FALSE(isLocallyConnected(ring, carved(ring, sphereBrush({3, 40, 3}, {6, 6, 6}))));
    EXPECT_EQ(componentSizes(ring).size(), 1u);
}

TEST(LocalConnectivity, IsNeverWrongInNoise) {
    Random random(4);
    int whole = 0, boxesConnected = 0, apart = 0;
    for (int i = 0; i < 300; ++i) {
        VoxelGrid grid(glm::ivec3(48));
        GridWriter writer(grid);
        const uint32_t fill = 40 + random.below(50);
        for (int c = 0; c < 48 * 48 * 48; ++c)
            if (random.below(100) < fill) writer.set({c % 48, c / 48 % 48, c / 48 / 48}, 1);
        writer.flush();
        std::vector<Component> parts = findComponents(grid);  // only the largest: before a cut all is connected
        std::sort(parts.begin(), parts.end(), isLargerComponent);
        for (size_t p = 1; p < parts.size(); ++p) takePiece(grid, parts[p]);
        const double x = 48.0 * random.unit(), y = 48.0 * random.unit(), z = 48.0 * random.unit(),
                     radius = 1.0 + 7.0 * random.unit();
        const CarveResult gone = cut(grid, sphereBrush({x, y, z}, {radius, radius, radius}));
        BrickSet bricks;
        for (const glm::ivec3 brick : gone.bricks) bricks.insert(brick);
        const bool isWhole = isLocallyConnected(grid, bricks),
                   isBoxConnected = isLocallyConnected(grid, gone.cells, {});
        const size_t count = componentSizes(grid).size();
        ASSERT_TRUE(!isWhole || count <= 1);
        ASSERT_TRUE(!isBoxConnected || count <= 1);
        boxesConnected += isBoxConnected;
        whole += isWhole, apart += count > 1;
    }
    EXPECT_GT(whole, 30);
    EXPECT_GT(boxesConnected, 30);
    EXPECT_GT(apart, 30);
}

}  // namespace
}  // namespace rubble
