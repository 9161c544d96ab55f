#include "runtime/destruction/attachment.h"

#include <gtest/gtest.h>

#include "runtime/destruction/carve.h"
#include "runtime/destruction/split.h"
#include "tests/runtime/destruction/oracle.h"

namespace rubble {
namespace {

using CellSets = std::vector<std::vector<size_t>>;

/// What a flood fill says leaves the grid.
CellSets looseByFloodFill(const VoxelGrid& grid, const std::vector<CellBox>& anchors, bool isAnchored, bool* isAdrift) {
    const test::PlainGrid plain(grid);
    CellSets sets = test::floodFill(plain);
    const auto isHeld = [&](const std::vector<size_t>& set) {
        for (size_t i : set)
            for (const CellBox& box : anchors)
                if (glm::all(glm::greaterThanEqual(plain.cell(i), box.low)) && glm::all(glm::lessThan(plain.cell(i), box.high))) return true;
        return false;
    };
    const size_t all = sets.size();
    if (isAnchored) std::erase_if(sets, isHeld);
    *isAdrift = isAnchored && all > 0 && sets.size() == all;
    if ((!isAnchored || *isAdrift) && !sets.empty())
        sets.erase(std::max_element(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); }));
    return sets;
}

void expectSame(const Loose& loose, const CellSets& expected, bool isAdrift, const VoxelGrid& grid) {
    const test::PlainGrid plain(grid);
    ASSERT_EQ(loose.pieces.size(), expected.size());
    ASSERT_EQ(loose.isAdrift, isAdrift);
    for (size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(test::cellsOf(loose.pieces[i], plain), expected[i]);
        ASSERT_EQ(loose.pieces[i].voxels, expected[i].size());
        ASSERT_EQ(plain.index(loose.pieces[i].lowest), expected[i].front());
    }
}

/// Carves at random places; after each carve the local search must find what a flood fill finds, and takes it away.
void carveAndCompare(VoxelGrid grid, std::vector<CellBox> anchors, bool isAnchored, uint64_t seed, int carves, double radius) {
    const Palette palette = test::fiveEntries();
    const MaterialTable materials = test::fiveMaterials();
    Random random(seed);
    bool isKnown = false;
    for (int i = 0; i < carves && !grid.empty(); ++i) {
        Carved carved;
        for (int cut = 0; cut < 1 + i % 3; ++cut) {
            const double x = random.below(uint32_t(grid.size().x * 16)) / 16.0;
            const double y = random.below(uint32_t(grid.size().y * 16)) / 16.0;
            const double z = random.below(uint32_t(grid.size().z * 16)) / 16.0;
            carve(grid, sphereBrush({x, y, z}, {radius, radius, radius}), palette, materials, carved);
        }
        std::sort(carved.bricks.begin(), carved.bricks.end(), cellBefore);
        carved.bricks.erase(std::unique(carved.bricks.begin(), carved.bricks.end()), carved.bricks.end());
        bool isAdrift = false;
        const CellSets expected = looseByFloodFill(grid, anchors, isAnchored, &isAdrift);
        const Loose loose = isKnown ? findLooseNear(grid, anchors, isAnchored, carved.bricks) : findLoose(grid, anchors, isAnchored);
        expectSame(loose, expected, isAdrift, grid);
        if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed << ", carve " << i;
        isKnown = true;
        for (const Component& component : loose.pieces) takePiece(grid, component);
        if (isAdrift) isAnchored = false;
    }
}

TEST(Attachment, LocalSearchEqualsAFloodFill) {
    const glm::ivec3 size(40, 38, 36);
    const std::vector<CellBox> bottom = {{{0, 0, 0}, {40, 1, 36}}};
    const std::vector<CellBox> corners = {{{0, 0, 0}, {3, 38, 3}}, {{36, 30, 30}, {40, 38, 36}}};
    for (uint64_t seed = 1; seed <= 2; ++seed) {
        carveAndCompare(test::towerGrid(size), bottom, true, seed, 40, 3.0);
        carveAndCompare(test::towerGrid(size), corners, true, seed, 40, 4.0);
        carveAndCompare(test::towerGrid(size), {}, false, seed, 40, 4.0);
        carveAndCompare(test::noiseGrid(size, 40, seed), bottom, true, seed, 25, 2.5);
        carveAndCompare(test::noiseGrid(size, 33, seed), {}, false, seed, 25, 2.5);
        carveAndCompare(test::solidGrid({40, 40, 40}), bottom, true, seed, 25, 9.0);
    }
}

TEST(Attachment, WithoutAnyAnchorTheLargestStays) {
    VoxelGrid grid({24, 8, 8});
    {
        GridWriter writer(grid);
        for (int x = 0; x < 20; ++x) writer.set({x, 4, 4}, 1);
    }
    const std::vector<CellBox> anchors = {{{0, 0, 0}, {24, 1, 8}}};
    const Loose all = findLoose(grid, anchors, true);
    EXPECT_TRUE(all.isAdrift);
    EXPECT_TRUE(all.pieces.empty());
    GridWriter(grid).set({8, 4, 4}, 0);
    const Loose cut = findLoose(grid, anchors, true);
    EXPECT_TRUE(cut.isAdrift);
    ASSERT_EQ(cut.pieces.size(), 1u);
    EXPECT_EQ(cut.pieces[0].voxels, 8u);
}

TEST(Attachment, OfEqualPiecesTheLowestStays) {
    VoxelGrid grid({8, 8, 24});
    {
        GridWriter writer(grid);
        for (int z = 0; z < 21; ++z)
            if (z != 10) writer.set({4, 4, z}, 1);
    }
    const std::vector<glm::ivec3> carved = {{0, 0, 1}};
    for (const Loose& loose : {findLoose(grid, {}, false), findLooseNear(grid, {}, false, carved)}) {
        ASSERT_EQ(loose.pieces.size(), 1u);
        EXPECT_EQ(loose.pieces[0].lowest, glm::ivec3(4, 4, 11));
    }
}

}  // namespace
}  // namespace rubble
