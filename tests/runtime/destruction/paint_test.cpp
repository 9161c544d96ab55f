#include "runtime/destruction/paint.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/runtime/destruction/reference_algorithms.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

PaletteEntry withoutColor(PaletteEntry entry) {
    entry.red = entry.green = entry.blue = 0;
    return entry;
}
std::array<uint8_t, 3> colorOf(const PaletteEntry& entry) {
    return {entry.red, entry.green, entry.blue};
}

PaletteRef shared(const Palette& palette) {
    return std::make_shared<const Palette>(palette);
}

bool isExposed(const test::PlainGrid& grid, glm::ivec3 cell) {
    for (const glm::ivec3 step : kFaceOffsets)
        if (!grid.contains(cell + step) || !grid.cells[grid.index(cell + step)]) return true;
    return false;
}

/// A palette of many colours and all kinds of entries, and a grid that uses all of them.
struct UsedPalette {
    VoxelGrid grid{glm::ivec3(32)};
    Palette palette{};
    explicit UsedPalette(int entries) {
        Random random(4);
        for (int i = 1; i <= entries; ++i) {
            PaletteEntry& entry = palette[size_t(i)];
            entry.red = uint8_t(random.below(256));
            entry.green = uint8_t(random.below(256));
            entry.blue = uint8_t(random.below(256));
            entry.material = uint8_t(1 + i % 3);
            entry.emission = i % 7 == 0 ? 2.0f : 0.0f;
            entry.lightGroup = i % 7 == 0 ? 1 : 0;
        }
        GridWriter writer(grid);
        for (int i = 0; i < 32 * 32 * 32; ++i)
            writer.set({i & 31, i >> 5 & 31, i >> 10}, uint8_t(1 + random.below(uint32_t(entries))));
    }
};

TEST(Paint, ReachesThePaintAndLeavesEverythingElse) {
    for (const int entries : {3, 28, 40, 200}) {
        UsedPalette scene(entries);
        const test::PlainGrid before(scene.grid);
        const Palette original = scene.palette;
        const Brush sphere = sphereBrush({31, 16, 16}, {9, 9, 9});
        PaletteRef palette = shared(scene.palette);
        uint64_t voxels = 1, merges = 0;
        for (int step = 0; voxels > 0; ++step) {
            ASSERT_LT(step, 64) << "the paint is never reached";
            const PaintResult painted = paintPalette(scene.grid, palette, sphere, {{250, 20, 30}, 64, 255, 0});
            if (painted.palette) palette = painted.palette;
            voxels = painted.voxels;
            merges += painted.merges;
        }
        const test::PlainGrid after(scene.grid);
        std::set<uint8_t> classes;
        for (size_t i = 0; i < after.cells.size(); ++i) {
            const glm::ivec3 cell = after.cell(i);
            const PaletteEntry& was = original[before.cells[i]];
            const PaletteEntry& is = (*palette)[after.cells[i]];
            ASSERT_EQ(withoutColor(is), withoutColor(was));
            const bool inside =
                brushContains(sphere, {cell.x * 256 + 128, cell.y * 256 + 128, cell.z * 256 + 128}, sphere.radii[0]);
            if (inside && isExposed(before, cell)) {
                ASSERT_EQ(colorOf(is), (std::array<uint8_t, 3>{250, 20, 30})) << entries << " entries";
            } else {
                ASSERT_EQ(is, was) << "a voxel outside of the brush changed";
            }
        }
        EXPECT_EQ(merges > 0, entries == 200) << "merges are counted only when the palette has too few free entries";
    }
}

TEST(Paint, AFullPaletteIsReportedAndStaysValid) {
    UsedPalette scene(255);
    const test::PlainGrid before(scene.grid);
    const PaintResult painted = paintPalette(scene.grid, shared(scene.palette), sphereBrush({31, 16, 16}, {9, 9, 9}),
                                             {{250, 20, 30}, 64, 255, 0});
    EXPECT_GT(painted.merges, 0u);
    EXPECT_EQ(painted.palette, nullptr);
    const test::PlainGrid after(scene.grid);
    for (size_t i = 0; i < after.cells.size(); ++i)
        ASSERT_EQ(withoutColor(scene.palette[after.cells[i]]), withoutColor(scene.palette[before.cells[i]]));
}

TEST(Paint, UnusedEntriesAreFreed) {
    // A .vox file has 255 entries; the grid uses one.
    UsedPalette scene(255);
    VoxelGrid grid = solidGrid({16, 16, 16}, 9);
    const PaintResult painted =
        paintPalette(grid, shared(scene.palette), sphereBrush({16, 8, 8}, {5, 5, 5}), {{1, 2, 3}, 64, 255, 0});
    ASSERT_NE(painted.palette, nullptr);
    EXPECT_EQ(painted.merges, 0u);
    EXPECT_EQ((*painted.palette)[9], scene.palette[9]);
}

TEST(Paint, EntriesThatEqualAnotherOneAreTakenBeforeOthers) {
    UsedPalette scene(255);
    for (size_t i = 201; i < 256; ++i) scene.palette[i] = scene.palette[200];
    VoxelGrid grid = solidGrid({16, 16, 16}, 9);
    PaletteRef palette = shared(scene.palette);
    for (uint8_t i = 0; i < 6; ++i) {
        const Paint paint{{uint8_t(40 * i), uint8_t(255 - 40 * i), 3}, 255, 255, 0};
        const PaintResult painted = paintPalette(grid, palette, sphereBrush({16, 8, 2 * i}, {3, 3, 3}), paint);
        EXPECT_GT(painted.voxels, 0u);
        if (painted.palette) palette = painted.palette;
    }
    for (size_t i = 1; i <= 200; ++i) EXPECT_EQ((*palette)[i], scene.palette[i]);
}

TEST(Paint, ProbabilityThinsTheRimOnly) {
    VoxelGrid grid = solidGrid({64, 64, 8});
    const PaintResult painted = paintPalette(grid, shared(test::fiveEntries()), sphereBrush({32, 32, 4}, {24, 24, 24}),
                                             {{9, 9, 9}, 255, 30, 7});
    ASSERT_TRUE(painted.palette);
    int middle = 0, middleAll = 0, rim = 0, rimAll = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const double away = glm::length(glm::dvec2(x + 0.5 - 32, y + 0.5 - 32));
            const bool isPainted = grid.at({x, y, 7}) != 1;
            if (away < 4) ++middleAll, middle += isPainted;
            if (away > 20 && away < 23.5) ++rimAll, rim += isPainted;
            EXPECT_FALSE(away > 25 && isPainted);
        }
    EXPECT_GT(middle, middleAll * 9 / 10);
    EXPECT_LT(rim, rimAll / 2);
    EXPECT_GT(rim, 0);
}

TEST(Paint, EntriesWithoutAMaterialThatVoxelsHaveAreNotTaken) {
    VoxelGrid grid = gridOf({16, 8, 8}, [](glm::ivec3 c) { return uint8_t(c.x < 8 ? 1 : 2 + c.y); });
    Palette palette{};
    palette[1] = {.red = 10, .material = 1};
    for (size_t i = 2; i < 10; ++i) palette[i] = {.red = uint8_t(20 * i), .material = 0};
    const Palette before = palette;
    PaletteRef now = shared(palette);
    for (int step = 0; step < 40; ++step) {
        const PaintResult painted =
            paintPalette(grid, now, sphereBrush({8, 4, 4}, {20, 20, 20}), {.color = {250, 0, 9}, .strength = 20});
        if (painted.palette) now = painted.palette;
        for (size_t i = 2; i < 10; ++i) ASSERT_EQ((*now)[i], before[i]) << "entry " << i << " has voxels";
    }
    EXPECT_NE(grid.at({0, 0, 0}), 1) << "painted";
}

}  // namespace
}  // namespace rubble
