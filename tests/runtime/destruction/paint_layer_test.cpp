#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "runtime/destruction/paint.h"
#include "runtime/destruction/split.h"
#include "tests/runtime/destruction/reference_algorithms.h"

namespace rubble {
namespace {

uint8_t paintAt(const VoxelGrid& grid, glm::ivec3 cell) {
    const Brick* brick = grid.brickAt(brickOfCell(cell));
    return brick ? brick->paintAt(voxelIndex(cellInBrick(cell))) : uint8_t(0);
}

/// The visible colour of a voxel.
Srgb seen(const VoxelGrid& grid, const Palette& palette, const PaintColors* colors, glm::ivec3 cell) {
    const PaletteEntry& entry = palette[grid.at(cell)];
    const uint8_t paint = paintAt(grid, cell);
    const Srgb own{entry.red, entry.green, entry.blue};
    return paint ? paintOver(own, colors->colors[size_t(paintColor(paint) - 1)], paintSteps(paint)) : own;
}

/// A wall that shows all 255 entries.
VoxelGrid wallOfAllEntries() {
    VoxelGrid grid({64, 64, 8});
    GridWriter writer(grid);
    for (int i = 0; i < 64 * 64 * 8; ++i)
        writer.set({i & 63, i >> 6 & 63, i >> 12}, uint8_t(1 + (i * 7 + (i >> 6)) % 255));
    return grid;
}

TEST(PaintLayer, AllEntriesTakeFifteenColoursInSixteenSteps) {
    VoxelGrid grid = wallOfAllEntries();
    const test::PlainGrid before(grid);
    PaintColorsRef colors;
    std::set<int> bytes;
    for (int c = 1; c <= kPaintColors; ++c)
        for (int s = 1; s <= kPaintSteps; ++s) {  // a spot of a few voxels for every colour and number of steps
            const glm::dvec3 spot(4 * c - 1.5, 4 * s - 2.5, 7.5);
            const Paint paint{.color = {uint8_t(16 * c), uint8_t(255 - 16 * c), 77},
                              .strength = uint8_t(255 * s / 16),
                              .seed = uint32_t(c)};
            const PaintResult painted = paintLayer(grid, colors, sphereBrush(spot, {1.6, 1.6, 1.6}), paint);
            if (painted.colors) colors = painted.colors;
            EXPECT_EQ(painted.merges, 0u);
            EXPECT_GT(painted.voxels, 0u);
            const int steps = paintSteps(paintAt(grid, {4 * c - 2, 4 * s - 3, 7}));
            EXPECT_NEAR(steps, s, 1) << "a step is dithered by less than one";
            bytes.insert(paintByte(c, s));
        }
    EXPECT_EQ(colors->count, kPaintColors);
    EXPECT_EQ(bytes.size(), size_t(kPaintColors * kPaintSteps));
    const test::PlainGrid after(grid);
    EXPECT_EQ(before.cells, after.cells) << "the paint layer must not change palette indices";

    const PaintResult more =
        paintLayer(grid, colors, sphereBrush({30, 30, 7.5}, {3, 3, 3}), {.color = {1, 250, 80}, .strength = 255});
    EXPECT_EQ(more.colors, nullptr);
    EXPECT_EQ(more.merges, 1u) << "a sixteenth colour takes the nearest one and is counted";
    EXPECT_EQ(paintAt(grid, {30, 30, 7}), paintByte(1, 16));
}

TEST(PaintLayer, BothModesLookAlike) {
    Palette entries{};
    for (size_t i = 1; i <= 28; ++i)
        entries[i] = {.red = uint8_t(9 * i), .green = uint8_t(250 - 5 * i), .blue = uint8_t(40 * i), .material = 1};
    VoxelGrid wall({32, 32, 8});
    {
        GridWriter writer(wall);
        for (int i = 0; i < 32 * 32 * 8; ++i) writer.set({i & 31, i >> 5 & 31, i >> 10}, uint8_t(1 + i % 28));
    }
    const Brush brush = sphereBrush({16, 16, 8}, {14, 14, 14});
    for (const int step : {2, 5, 9, 16}) {
        VoxelGrid byPalette = wall, byLayer = wall;
        const Paint paint{.color = {200, 30, 60}, .strength = uint8_t((255 * step + 8) / 16), .seed = 5};
        PaletteRef palette = std::make_shared<const Palette>(entries);
        const PaintResult a = paintPalette(byPalette, palette, brush, paint);
        const PaintResult b = paintLayer(byLayer, nullptr, brush, paint);
        EXPECT_EQ(a.merges, 0u);
        EXPECT_EQ(a.voxels, b.voxels) << "the same voxels are touched";
        if (a.palette) palette = a.palette;
        double sum = 0;
        int largest = 0, count = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const Srgb one = seen(byPalette, *palette, nullptr, {x, y, 7}),
                           two = seen(byLayer, entries, b.colors.get(), {x, y, 7});
                for (size_t c = 0; c < 3; ++c, ++count)
                    sum += one[c] - two[c], largest = std::max(largest, std::abs(one[c] - two[c]));
            }
        EXPECT_LE(largest, 255 / 16 + 3 + 2) << "at most a dithered step and a near entry apart, at step " << step;
        EXPECT_NEAR(sum / count, 0.0, 2.5) << "the same on average, at step " << step;
    }
}

TEST(PaintLayer, FalloffWeakensAndTheRimIsBlueNoise) {
    VoxelGrid grid = solidGrid({64, 64, 8});
    const PaintResult painted = paintLayer(grid, nullptr, sphereBrush({32, 32, 7.5}, {28, 28, 28}),
                                           {.color = {9, 9, 9}, .strength = 128, .falloff = 0});
    ASSERT_TRUE(painted.colors);
    double byRing[4] = {}, count[4] = {};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const int ring = int(std::hypot(x + 0.5 - 32, y + 0.5 - 32) / 7);
            if (ring < 4) byRing[ring] += paintSteps(paintAt(grid, {x, y, 7})), ++count[ring];
        }
    for (int r = 0; r < 4; ++r) byRing[r] /= count[r];
    EXPECT_NEAR(byRing[0], 8.0, 0.5);
    for (int r = 1; r < 4; ++r) EXPECT_LT(byRing[r], byRing[r - 1] - 0.5);

    // A sparse spray is dithered by blue noise: neighbours differ more often than with independent random numbers.
    VoxelGrid thin = solidGrid({64, 64, 8});
    paintLayer(thin, nullptr, sphereBrush({32, 32, 7.5}, {46, 46, 46}),
               {.color = {9, 9, 9}, .strength = 255, .probability = 0});
    const auto share = [](int x, int y) {
        return std::max(0.0, 1 - (std::pow(x + 0.5 - 32, 2) + std::pow(y + 0.5 - 32, 2)) / (46 * 46));
    };
    double chosen = 0, expected = 0, differ = 0, independent = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 63; ++x) {
            const bool here = paintAt(thin, {x, y, 7}), next = paintAt(thin, {x + 1, y, 7});
            const double p = share(x, y), q = share(x + 1, y);
            chosen += here, expected += p;
            differ += here != next, independent += p * (1 - q) + q * (1 - p);
        }
    EXPECT_NEAR(chosen / expected, 1.0, 0.02);
    EXPECT_GT(differ / independent, 1.15);
}

TEST(PaintLayer, AStrokeIsAsWideAsItsRadius) {
    VoxelGrid grid = solidGrid({80, 32, 8});
    const glm::dvec3 from(10, 10, 7.5), to(70, 20, 7.5);
    paintLayer(grid, nullptr, capsuleBrush(from, to, {4, 4, 4}), {.color = {20, 20, 20}, .strength = 255});
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 80; ++x) {
            const glm::dvec3 cell(x + 0.5, y + 0.5, 7.5), along = to - from;
            const double t = std::clamp(glm::dot(cell - from, along) / glm::dot(along, along), 0.0, 1.0);
            const double away = glm::length(cell - from - along * t);
            if (std::abs(away - 4) > 0.02) {
                EXPECT_EQ(paintAt(grid, {x, y, 7}) != 0, away < 4) << x << " " << y;
            }
        }
}

TEST(PaintLayer, OnePaintCoversAnother) {
    VoxelGrid grid = solidGrid({32, 32, 8});
    const Brush brush = sphereBrush({16, 16, 7.5}, {9, 9, 9});
    PaintColorsRef colors = paintLayer(grid, nullptr, brush, {.color = {255, 0, 0}, .strength = 255}).colors;
    for (uint32_t seed = 0; seed < 60; ++seed) {
        const PaintResult painted =
            paintLayer(grid, colors, brush, {.color = {0, 0, 255}, .strength = 64, .seed = seed});
        if (painted.colors) colors = painted.colors;
        if (seed != 0) continue;
        int blue = 0, all = 0;
        for (int y = 8; y < 24; ++y)
            for (int x = 8; x < 24; ++x) ++all, blue += paintColor(paintAt(grid, {x, y, 7})) == 2;
        EXPECT_NEAR(double(blue) / all, 0.25, 0.05);
    }
    EXPECT_EQ(paintAt(grid, {16, 16, 7}), paintByte(2, 16));
    EXPECT_EQ(paintAt(grid, {16, 10, 7}), paintByte(2, 16));
}

TEST(PaintLayer, GoesWithPiecesAndCosts512BytesAPaintedBrick) {
    VoxelGrid grid({64, 16, 16});
    {
        GridWriter writer(grid);
        for (int i = 0; i < 64 * 16 * 16; ++i)
            if ((i & 63) < 20 || (i & 63) > 27) writer.set({i & 63, i >> 6 & 15, i >> 10}, 1);
    }
    const size_t plain = grid.memoryBytes();
    const PaintResult painted =
        paintLayer(grid, nullptr, sphereBrush({30, 8, 16}, {14, 14, 14}), {.color = {1, 2, 3}, .strength = 200});
    EXPECT_EQ(grid.memoryBytes(), plain + 512 * painted.bricks.size());
    const VoxelGrid whole = grid;
    const std::vector<Component> parts = findComponents(grid);
    ASSERT_EQ(parts.size(), 2u);
    const Piece piece = takePiece(grid, parts[1]);
    uint64_t moved = 0;
    for (int z = 0; z < 16; ++z)
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 64; ++x) {
                const glm::ivec3 cell(x, y, z);
                const bool isMoved = x > 27;
                ASSERT_EQ(paintAt(grid, cell), isMoved ? 0 : paintAt(whole, cell));
                if (!isMoved) continue;
                ASSERT_EQ(paintAt(piece.grid, cell - piece.offset), paintAt(whole, cell));
                moved += paintAt(whole, cell) != 0;
            }
    EXPECT_GT(moved, 100u);
}

}  // namespace
}  // namespace rubble
