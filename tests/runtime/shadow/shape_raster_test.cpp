#include "runtime/shadow/shape_raster.h"

#include <gtest/gtest.h>

#include "tests/runtime/shadow/received_volume.h"

namespace rubble {
namespace {

/// The sampling rule of ShadowCellTransform, one sample at a time, in integers.
bool isSet(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, glm::ivec3 cell) {
    const int n = cellTransform.samples;
    for (int s = 0; s < n * n * n; ++s) {
        const glm::ivec3 sub(s % n, s / n % n, s / n / n);
        FixedPoint at = cellTransform.sample(cell);
        for (size_t a = 0; a < 3; ++a)
            for (size_t k = 0; k < 3; ++k) at[k] += sub[int(a)] * cellTransform.step[a][k];
        if (grid.at({int(at[0] >> 32), int(at[1] >> 32), int(at[2] >> 32)})) return true;
    }
    return false;
}

struct Piece {
    VoxelGrid grid;
    Pose pose;
    double voxelSize = 0.1;
};

/// A random shape: full, without a corner, hollow, or of noise.
Piece drawPiece(Random& random) {
    const glm::ivec3 size(random.between(1, 19), random.between(1, 19),
                          random.between(1, 19));  // small enough with the largest voxels
    const uint32_t kind = random.below(4);
    const int corner = random.between(1, 40);
    Piece piece;
    piece.grid = gridOf(size, [&](glm::ivec3 c) {
        const glm::ivec3 far = size - 1 - c;
        if (kind == 0) return uint8_t(1);
        if (kind == 1) return uint8_t(c.x + c.y + c.z >= corner);
        if (kind == 2) return uint8_t(std::min({c.x, c.y, c.z, far.x, far.y, far.z}) == 0);
        return uint8_t(random.below(3) == 0);
    });
    piece.pose = {drawPoint(random, -3.0, 3.0), drawRotation(random)};
    const uint32_t turn = random.below(6);  // along the axes: rows that touch faces exactly
    if (turn == 0) piece.pose.rotation = glm::dquat(1, 0, 0, 0);
    if (turn == 1) piece.pose.rotation = glm::dquat(0.5, 0.5, 0.5, 0.5);
    if (turn == 2) piece.pose.rotation = glm::dquat(std::sqrt(0.5), 0, std::sqrt(0.5), 0);
    if (random.below(3) == 0) piece.pose.position = glm::round(piece.pose.position * 20.0) / 20.0;
    if (random.below(4) == 0) piece.voxelSize = random.below(2) ? 0.05 : 0.17;
    return piece;
}

size_t countWrong(const Piece& piece) {
    ShadowCellTransform cellTransform;
    EXPECT_TRUE(cellTransform.place(piece.pose, piece.voxelSize));
    const CellBox bounds = shadowBounds(piece.pose, piece.voxelSize, {glm::ivec3(0), piece.grid.size()});
    RasterSource source;
    source.make(piece.grid);
    ShapeRaster raster;
    EXPECT_TRUE(raster.make(source, cellTransform, bounds));
    size_t wrong = 0, set = 0, listed = 0;
    for (int z = bounds.low.z - 2; z < bounds.high.z + 2; ++z)
        for (int y = bounds.low.y - 2; y < bounds.high.y + 2; ++y)
            for (int x = bounds.low.x - 2; x < bounds.high.x + 2; ++x) {
                const glm::ivec3 cell(x, y, z), word = cell >> 2 & 3, bit = cell & 3;
                const ShadowWords* words = raster.find(cell >> 4);
                const bool found =
                    words &&
                    (*words)[size_t(word.x + 4 * word.y + 16 * word.z)] >> (bit.x + 4 * bit.y + 16 * bit.z) & 1;
                const bool expected = isSet(piece.grid, cellTransform, cell);
                wrong += found != expected;
                set += expected;
            }
    raster.forEach([&](glm::ivec3 brick, const ShadowWords& words) {
        EXPECT_EQ(raster.find(brick), &words);
        for (const uint64_t word : words) listed += size_t(std::popcount(word));
    });
    EXPECT_EQ(listed, set) << "cells outside the bounds, or bricks not listed";
    return wrong;
}

TEST(ShapeRaster, FollowsTheSamplingRule) {
    Random random(31);
    for (int round = 0; round < 300; ++round) ASSERT_EQ(countWrong(drawPiece(random)), 0u) << "round " << round;
}

TEST(ShapeRaster, TheSolidBoxIsSolidAndLarge) {
    Random random(32);
    for (int round = 0; round < 40; ++round) {
        const Piece piece = drawPiece(random);
        RasterSource source;
        source.make(piece.grid);
        const CellBox solidBox = source.solidBox();
        if (piece.grid.empty()) {
            EXPECT_TRUE(solidBox.empty());
            continue;
        }
        ASSERT_FALSE(solidBox.empty());
        for (int z = solidBox.low.z; z < solidBox.high.z; ++z)
            for (int y = solidBox.low.y; y < solidBox.high.y; ++y)
                for (int x = solidBox.low.x; x < solidBox.high.x; ++x) ASSERT_TRUE(piece.grid.at({x, y, z}));
        const glm::ivec3 size = solidBox.high - solidBox.low, all = piece.grid.size();
        if (piece.grid.voxelCount() == uint64_t(all.x) * uint64_t(all.y) * uint64_t(all.z)) {
            EXPECT_EQ(size, all);
        }
    }
}

TEST(ShapeRaster, FailsWhenTheBoundsAreTooWide) {
    const VoxelGrid grid = gridOf({64, 2, 2}, [](glm::ivec3) { return uint8_t(1); });
    ShadowCellTransform cellTransform;
    ASSERT_TRUE(cellTransform.place({}, 0.1));
    RasterSource source;
    source.make(grid);
    ShapeRaster raster;
    EXPECT_FALSE(raster.make(source, cellTransform, shadowBounds({}, 0.1, {glm::ivec3(0), grid.size()})));
    EXPECT_FALSE(raster.isMade());
}

}  // namespace
}  // namespace rubble
