#include "runtime/destruction/detachment.h"

#include <gtest/gtest.h>

#include "runtime/destruction/carve.h"
#include "runtime/destruction/split.h"
#include "tests/runtime/destruction/reference_algorithms.h"
#include "tests/support/detached_near.h"

namespace rubble {
namespace {

using CellSets = std::vector<std::vector<size_t>>;

BrickSet bricksOf(const std::vector<glm::ivec3>& bricks) {
    BrickSet out;
    for (const glm::ivec3 brick : bricks) out.insert(brick);
    return out;
}

/// What leaves the grid, by flood fill.
CellSets detachedByFloodFill(const VoxelGrid& grid, const std::vector<CellBox>& anchors, bool isAnchored,
                             bool* isUnanchored) {
    const test::PlainGrid plain(grid);
    CellSets sets = test::floodFill(plain);
    const auto isHeld = [&](const std::vector<size_t>& set) {
        for (size_t i : set)
            for (const CellBox& box : anchors)
                if (glm::all(glm::greaterThanEqual(plain.cell(i), box.low)) &&
                    glm::all(glm::lessThan(plain.cell(i), box.high)))
                    return true;
        return false;
    };
    const size_t all = sets.size();
    if (isAnchored) std::erase_if(sets, isHeld);
    *isUnanchored = isAnchored && all > 0 && sets.size() == all;
    if ((!isAnchored || *isUnanchored) && !sets.empty())
        sets.erase(std::max_element(sets.begin(), sets.end(),
                                    [](const auto& a, const auto& b) { return a.size() < b.size(); }));
    return sets;
}

void expectSame(const Detached& detached, const CellSets& expected, bool isUnanchored, const VoxelGrid& grid) {
    const test::PlainGrid plain(grid);
    ASSERT_EQ(detached.pieces.size(), expected.size());
    ASSERT_EQ(detached.isUnanchored, isUnanchored);
    for (size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(test::cellsOf(detached.pieces[i], grid, plain), expected[i]);
        ASSERT_EQ(detached.pieces[i].voxels, expected[i].size());
        ASSERT_EQ(plain.index(detached.pieces[i].lowest), expected[i].front());
    }
}

/// Carves at random positions. After each carve the local search must find what a flood fill finds; that is removed.
void carveAndCompare(VoxelGrid grid, std::vector<CellBox> anchors, bool isAnchored, uint64_t seed, int carves,
                     double radius) {
    const Palette palette = test::fiveEntries();
    const MaterialTable materials = test::fiveMaterials();
    Random random(seed);
    bool isKnown = false;
    for (int i = 0; i < carves && !grid.empty(); ++i) {
        CarveResult carved;
        for (int cut = 0; cut < 1 + i % 3; ++cut) {
            const double x = random.below(uint32_t(grid.size().x * 16)) / 16.0;
            const double y = random.below(uint32_t(grid.size().y * 16)) / 16.0;
            const double z = random.below(uint32_t(grid.size().z * 16)) / 16.0;
            carve(grid, sphereBrush({x, y, z}, {radius, radius, radius}), palette, materials, carved);
        }
        bool isUnanchored = false;
        const CellSets expected = detachedByFloodFill(grid, anchors, isAnchored, &isUnanchored);
        const Detached detached = isKnown ? test::findDetachedNear(grid, anchors, isAnchored, bricksOf(carved.bricks))
                                          : findDetached(grid, anchors, isAnchored);
        expectSame(detached, expected, isUnanchored, grid);
        if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed << ", carve " << i;
        isKnown = true;
        for (const Component& component : detached.pieces) takePiece(grid, component);
        if (isUnanchored) isAnchored = false;
    }
}

TEST(Detachment, LocalSearchEqualsAFloodFill) {
    const glm::ivec3 size(40, 38, 36);
    const std::vector<CellBox> bottom = {{{0, 0, 0}, {40, 1, 36}}};
    const std::vector<CellBox> corners = {{{0, 0, 0}, {3, 38, 3}}, {{36, 30, 30}, {40, 38, 36}}};
    for (uint64_t seed = 1; seed <= 2; ++seed) {
        carveAndCompare(towerGrid(size), bottom, true, seed, 40, 3.0);
        carveAndCompare(towerGrid(size), corners, true, seed, 40, 4.0);
        carveAndCompare(towerGrid(size), {}, false, seed, 40, 4.0);
        carveAndCompare(noiseGrid(size, 40, seed), bottom, true, seed, 25, 2.5);
        carveAndCompare(noiseGrid(size, 33, seed), {}, false, seed, 25, 2.5);
        carveAndCompare(solidGrid({40, 40, 40}), bottom, true, seed, 25, 9.0);
    }
}

TEST(Detachment, LosingTheOnlyAnchorDetaches) {
    VoxelGrid grid({24, 40, 8});
    {
        GridWriter writer(grid);
        for (int y = 0; y < 40; ++y) writer.set({2, y, 4}, 1), writer.set({20, y, 4}, 1);
    }
    const std::vector<CellBox> anchors = {{{0, 0, 0}, {24, 1, 8}}};
    ASSERT_TRUE(findDetached(grid, anchors, true).pieces.empty());
    GridWriter(grid).set({2, 0, 4}, 0);
    Detached detached = test::findDetachedNear(grid, anchors, true, bricksOf({glm::ivec3(0, 0, 0)}));
    ASSERT_EQ(detached.pieces.size(), 1u);
    EXPECT_FALSE(detached.isUnanchored);
    EXPECT_EQ(detached.pieces[0].voxels, 39u);
    takePiece(grid, detached.pieces[0]);
    GridWriter(grid).set({20, 0, 4}, 0);
    detached = test::findDetachedNear(grid, anchors, true, bricksOf({glm::ivec3(2, 0, 0)}));
    EXPECT_TRUE(detached.isUnanchored);
    EXPECT_TRUE(detached.pieces.empty());
}

TEST(Detachment, ALargePieceIsFoundAfterTheAnchoredSide) {
    VoxelGrid grid({64, 56, 64});
    {
        GridWriter writer(grid);
        for (int z = 0; z < 64; ++z)
            for (int x = 0; x < 64; ++x)
                for (int y = 0; y < 56; ++y) {
                    const bool isHead = y >= 32 && x >= 16 && x < 48 && z >= 16 && z < 48;
                    const bool isNeck = x >= 30 && x < 34 && z >= 30 && z < 34;
                    if (y < 16 || isHead || isNeck) writer.set({x, y, z}, 1);
                }
    }
    CarveResult carved;
    carve(grid, boxBrush({32, 24, 32}, {6, 2, 6}, {1, 0, 0, 0}, Hardness::Hard), test::fiveEntries(),
          test::fiveMaterials(), carved);
    const std::vector<CellBox> anchors = {{{0, 0, 0}, {64, 1, 64}}};
    const Detached detached = test::findDetachedNear(grid, anchors, true, bricksOf(carved.bricks));
    ASSERT_EQ(detached.pieces.size(), 1u);
    EXPECT_FALSE(detached.isUnanchored);
    EXPECT_EQ(detached.pieces[0].voxels, uint64_t(32 * 24 * 32 + 4 * 4 * 6));
}

TEST(Detachment, ALongThinPieceIsNotMistakenForTheLargest) {
    VoxelGrid grid({400, 24, 24});
    {
        GridWriter writer(grid);
        for (int i = 0; i < 24 * 24 * 24; ++i) writer.set({i % 24, i / 24 % 24, i / 576}, 1);
        for (int x = 24; x < 400; ++x) writer.set({x, 4, 4}, 1);
    }
    GridWriter(grid).set({26, 4, 4}, 0);
    const Detached detached = test::findDetachedNear(grid, {}, false, bricksOf({glm::ivec3(3, 0, 0)}));
    ASSERT_EQ(detached.pieces.size(), 1u);
    EXPECT_EQ(detached.pieces[0].voxels, 373u);
}

TEST(Detachment, WithoutAnyAnchorTheLargestStays) {
    VoxelGrid grid({24, 8, 8});
    {
        GridWriter writer(grid);
        for (int x = 0; x < 20; ++x) writer.set({x, 4, 4}, 1);
    }
    const std::vector<CellBox> anchors = {{{0, 0, 0}, {24, 1, 8}}};
    const Detached all = findDetached(grid, anchors, true);
    EXPECT_TRUE(all.isUnanchored);
    EXPECT_TRUE(all.pieces.empty());
    GridWriter(grid).set({8, 4, 4}, 0);
    const Detached cut = findDetached(grid, anchors, true);
    EXPECT_TRUE(cut.isUnanchored);
    ASSERT_EQ(cut.pieces.size(), 1u);
    EXPECT_EQ(cut.pieces[0].voxels, 8u);
}

TEST(Detachment, OfEqualPiecesTheLowestStays) {
    VoxelGrid grid({8, 8, 24});
    {
        GridWriter writer(grid);
        for (int z = 0; z < 21; ++z)
            if (z != 10) writer.set({4, 4, z}, 1);
    }
    const std::vector<glm::ivec3> carved = {{0, 0, 1}};
    for (const Detached& detached :
         {findDetached(grid, {}, false), test::findDetachedNear(grid, {}, false, bricksOf(carved))}) {
        ASSERT_EQ(detached.pieces.size(), 1u);
        EXPECT_EQ(detached.pieces[0].lowest, glm::ivec3(4, 4, 11));
    }
}

}  // namespace
}  // namespace rubble
