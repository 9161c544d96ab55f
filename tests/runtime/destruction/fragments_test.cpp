#include "runtime/destruction/fragments.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "runtime/destruction/pane.h"
#include "tests/runtime/destruction/reference_algorithms.h"

namespace rubble {
namespace {

/// Entry i is of material i of the default table.
Palette materialEntries() {
    Palette palette{};
    for (size_t i = 1; i < defaultMaterials().materials.size(); ++i) palette[i].material = uint8_t(i);
    return palette;
}
uint8_t entryOf(const char* material) {
    return defaultMaterials().find(material);
}

Brush ball(glm::dvec3 center, double radius) {
    return sphereBrush(center, {radius, radius, radius});
}

FractureResult fractureGrid(VoxelGrid& grid, const Brush& brush, const FracturePlan& plan = {}) {
    return fracture(grid, brush, materialEntries(), defaultMaterials(), plan);
}

uint64_t fragmentVoxels(const FractureResult& result) {
    uint64_t sum = 0;
    for (const Fragment& fragment : result.fragments) sum += fragment.piece.grid.voxelCount();
    return sum;
}

glm::ivec3 extent(const Fragment& fragment) {
    return fragment.piece.grid.size();
}

TEST(Fragments, EveryVoxelIsInTheRestOrInOneFragmentOrDust) {
    VoxelGrid grid = solidGrid({40, 40, 40});
    {
        GridWriter writer(grid);
        Random random(3);
        for (int z = 0; z < 40; ++z)
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 40; ++x)
                    writer.set({x, y, z}, x < 3 ? 4 : random.below(8) ? uint8_t(5 + (z / 9) % 4) : uint8_t(0));
    }
    const test::PlainGrid before(grid);
    const MassMoments all = gridMoments(grid, materialEntries(), defaultMaterials());
    const FractureResult result = fractureGrid(grid, ball({20, 20, 20}, 19.5));
    EXPECT_GT(result.fragments.size(), 20u);
    EXPECT_GT(result.dust.voxels, 0u);
    test::PlainGrid after(grid);
    MassMoments sum = gridMoments(grid, materialEntries(), defaultMaterials());
    sum += result.dust.moments;
    for (const Fragment& fragment : result.fragments) {
        EXPECT_EQ(
            fragment.moments,
            gridMoments(fragment.piece.grid, materialEntries(), defaultMaterials()).shifted(fragment.piece.offset));
        sum += fragment.moments;
        const test::PlainGrid piece(fragment.piece.grid);
        EXPECT_EQ(test::floodFill(piece).size(), 1u) << "connected";
        for (size_t i = 0; i < piece.cells.size(); ++i) {
            if (!piece.cells[i]) continue;
            const size_t at = after.index(piece.cell(i) + fragment.piece.offset);
            EXPECT_EQ(piece.cells[i], before.cells[at]);
            EXPECT_EQ(after.cells[at], 0);
            after.cells[at] = piece.cells[i];
        }
    }
    EXPECT_EQ(sum, all);
    uint64_t missing = 0;
    for (size_t i = 0; i < after.cells.size(); ++i) {
        if (after.cells[i] != before.cells[i]) ++missing;
        if (before.cells[i] == 4) {
            EXPECT_EQ(after.cells[i], 4) << "rock does not break";
        }
    }
    EXPECT_EQ(missing, result.dust.voxels);
    EXPECT_EQ(std::accumulate(result.dust.removed.begin(), result.dust.removed.end(), uint64_t(0)), result.dust.voxels);
}

TEST(Fragments, TheSeedDecidesTheResult) {
    const auto outcome = [](uint32_t seed) {
        VoxelGrid grid = solidGrid({32, 32, 32}, entryOf("concrete"));
        FracturePlan plan;
        plan.seed = seed;
        const FractureResult result = fractureGrid(grid, ball({16, 30, 16}, 12.3), plan);
        uint64_t hash = grid.contentHash();
        for (const Fragment& fragment : result.fragments)
            hash = hash * 31 + fragment.piece.grid.contentHash() + uint64_t(fragment.piece.offset.x);
        return hash;
    };
    EXPECT_EQ(outcome(5), outcome(5));
    EXPECT_NE(outcome(5), outcome(6));
}

TEST(Fragments, ToolsBreakMaterialsByTheTable) {
    FracturePlan plan;
    for (const auto& [tool, breaks] :
         {std::pair(Tool::Sledge, false), {Tool::Torch, true}, {Tool::Gun, true}, {Tool::Any, true}}) {
        VoxelGrid grid = solidGrid({16, 16, 16}, entryOf("metal"));
        plan.tool = tool;
        EXPECT_EQ(fractureGrid(grid, ball({8, 8, 8}, 6), plan).dust.bricks.empty(), !breaks) << int(tool);
    }
    VoxelGrid hard = solidGrid({16, 16, 16}, entryOf("hard masonry"));
    CarveResult carved;
    carve(hard, ball({8, 8, 8}, 6), materialEntries(), defaultMaterials(), carved, Tool::Gun);
    EXPECT_EQ(carved.voxels, 0u);
    carve(hard, ball({8, 8, 8}, 6), materialEntries(), defaultMaterials(), carved, Tool::Explosive);
    EXPECT_GT(carved.voxels, 0u);
}

/// Two panes in a wooden frame.
VoxelGrid window() {
    VoxelGrid grid({45, 22, 3});
    GridWriter writer(grid);
    for (int y = 0; y < 22; ++y)
        for (int x = 0; x < 45; ++x)
            for (int z = 0; z < 3; ++z) {
                const bool frame = x % 22 == 0 || y == 0 || y == 21 || x == 44;
                if (frame || z == 1) writer.set({x, y, z}, entryOf(frame ? "wood" : "glass"));
            }
    return grid;
}

TEST(Fragments, GlassBreaksByThePane) {
    VoxelGrid grid = window();
    const uint64_t before = grid.voxelCount();
    const FractureResult result = fractureGrid(grid, ball({10, 10, 1.5}, 2.0));
    EXPECT_EQ(before - grid.voxelCount(), 21u * 20) << "all of the left pane and nothing else";
    EXPECT_EQ(grid.at({11, 3, 1}), 0);
    EXPECT_EQ(grid.at({30, 3, 1}), entryOf("glass"));
    EXPECT_GT(result.fragments.size(), 8u);
    EXPECT_LT(result.dust.voxels, 21u * 20 / 2);
    // Between any two fragments there is a gap, so they cannot get stuck.
    std::map<std::array<int, 3>, size_t> fragmentAt;
    const auto key = [](glm::ivec3 cell) { return std::array<int, 3>{cell.x, cell.y, cell.z}; };
    for (size_t i = 0; i < result.fragments.size(); ++i) {
        const Piece& piece = result.fragments[i].piece;
        piece.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
            forEachVoxel(content->occupancy,
                         [&](int v) { fragmentAt[key(piece.offset + brick * kBrickSize + voxelInBrick(v))] = i; });
        });
    }
    for (const auto& [cell, fragment] : fragmentAt)
        for (int a = 0; a < 3; ++a) {
            std::array<int, 3> next = cell;
            ++next[size_t(a)];
            const auto other = fragmentAt.find(next);
            EXPECT_TRUE(other == fragmentAt.end() || other->second == fragment) << cell[0] << ' ' << cell[1];
        }
}

TEST(Fragments, APaneIsFoundAsAFloodFillFindsIt) {
    const VoxelGrid grid = noiseGrid({40, 40, 24}, 55, 9);
    test::PlainGrid plain(grid);
    for (uint8_t& cell : plain.cells) cell = cell == 2 ? 2 : 0;
    for (const std::vector<size_t>& set : test::floodFill(plain)) {
        const glm::ivec3 start = plain.cell(set[set.size() / 2]);
        std::vector<size_t> found;
        for (const BrickSubset& subset : findPane(
                 grid, start, [](uint8_t entry) { return entry == 2; }, 1u << 30))
            forEachVoxel(subset.voxels,
                         [&](int i) { found.push_back(plain.index(subset.brick * kBrickSize + voxelInBrick(i))); });
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, set);
    }
}

TEST(Fragments, WoodSplintersAlongItsLongestAxis) {
    for (const int axis : {0, 1, 2}) {
        glm::ivec3 size(6);
        size[axis] = 90;
        VoxelGrid grid = solidGrid(size, entryOf("wood"));
        const FractureResult result = fractureGrid(grid, ball(glm::dvec3(size) * 0.5, 15));
        ASSERT_GT(result.fragments.size(), 5u);
        int longAlong = 0;
        for (const Fragment& fragment : result.fragments) {
            const glm::ivec3 e = extent(fragment);
            longAlong += e[axis] > 2 * std::max(e[(axis + 1) % 3], e[(axis + 2) % 3]);
        }
        EXPECT_GT(longAlong * 2, int(result.fragments.size())) << axis;
    }
}

TEST(Fragments, TheirNumberIsBoundedAndMetalLosesLittle) {
    VoxelGrid grid = solidGrid({64, 64, 64}, entryOf("concrete"));
    FracturePlan plan;
    plan.maxFragments = 40;
    const FractureResult few = fractureGrid(grid, ball({32, 32, 32}, 28), plan);
    EXPECT_LE(few.fragments.size(), 40u);
    EXPECT_GT(few.fragments.size(), 15u);
    VoxelGrid metal = solidGrid({64, 64, 64}, entryOf("metal")), brick = solidGrid({64, 64, 64}, entryOf("brick"));
    fractureGrid(metal, ball({32, 32, 32}, 20));
    fractureGrid(brick, ball({32, 32, 32}, 20));
    EXPECT_GT(metal.voxelCount() - brick.voxelCount(), 20000u);
}

TEST(Fragments, KeepTheirPaint) {
    BrickIndices indices, paint;
    indices.fill(entryOf("concrete"));
    for (size_t i = 0; i < paint.size(); ++i) paint[i] = uint8_t(i * 7 % 251);
    VoxelGrid grid({16, 16, 16});
    for (int i = 0; i < 8; ++i) grid.setBrick({i & 1, i >> 1 & 1, i >> 2}, makeBrick(indices, &paint));
    const VoxelGrid before = grid;
    for (const Fragment& fragment : fractureGrid(grid, ball({8, 8, 8}, 7)).fragments)
        fragment.piece.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                const glm::ivec3 cell = position * kBrickSize + voxelInBrick(i) + fragment.piece.offset;
                EXPECT_EQ(brick->paintAt(i), before.brickAt(brickOfCell(cell))->paintAt(voxelIndex(cellInBrick(cell))));
            });
        });
}

TEST(Fragments, NothingBreaksOutsideOfTheSphere) {
    VoxelGrid grid = solidGrid({16, 16, 16}, entryOf("concrete"));
    EXPECT_TRUE(fractureGrid(grid, ball({80, 8, 8}, 6)).dust.bricks.empty());
    EXPECT_TRUE(fractureGrid(grid, ball({8, std::nan(""), 8}, 6)).dust.bricks.empty());
    EXPECT_EQ(fragmentVoxels(fractureGrid(grid, ball({8, 8, 8}, -1))), 0u);
    EXPECT_EQ(grid.voxelCount(), 4096u);
}

}  // namespace
}  // namespace rubble
