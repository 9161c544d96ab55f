#include "runtime/voxel/brick.h"

#include <gtest/gtest.h>

#include "runtime/core/random.h"
#include "runtime/voxel/paint_colors.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {
namespace {

struct Noise {
    BrickIndices indices{}, paint{};
    explicit Noise(uint64_t seed) {
        Random random(seed);
        for (size_t i = 0; i < kBrickVoxels; ++i) {
            indices[i] = uint8_t(random.below(3));
            paint[i] = random.below(2) ? uint8_t(16 + random.below(240)) : uint8_t(0);
        }
    }
};

TEST(Brick, KeepsThePaintOfSolidVoxelsOnly) {
    const Noise noise(1);
    const BrickRef brick = makeBrick(noise.indices, &noise.paint);
    for (int i = 0; i < kBrickVoxels; ++i) {
        ASSERT_EQ(brick->at(i), noise.indices[size_t(i)]);
        ASSERT_EQ(brick->paintAt(i), noise.indices[size_t(i)] ? noise.paint[size_t(i)] : 0) << i;
    }
    EXPECT_NE(hashBrick(*brick), hashBrick(*makeBrick(noise.indices)));
}

TEST(Brick, MasksKeepPaint) {
    const Noise noise(2);
    const BrickRef brick = makeBrick(noise.indices, &noise.paint);
    BrickBits keep;
    Random random(3);
    for (uint64_t& word : keep) word = random.next();
    const BrickRef part = maskBrick(*brick, keep);
    for (int i = 0; i < kBrickVoxels; ++i) {
        const bool isKept = hasVoxel(keep, i);
        ASSERT_EQ(part->at(i), isKept ? brick->at(i) : 0) << i;
        ASSERT_EQ(part->paintAt(i), isKept ? brick->paintAt(i) : 0) << i;
    }
}

TEST(Brick, WithoutPaintHasNoPaintBytes) {
    const Noise noise(4);
    EXPECT_EQ(makeBrick(noise.indices)->paint, nullptr);
    const BrickIndices none{};
    const BrickRef cleaned = makeBrick(noise.indices, &none);
    EXPECT_EQ(cleaned->paint, nullptr);
    EXPECT_EQ(hashBrick(*cleaned), hashBrick(*makeBrick(noise.indices)))
        << "the hash depends on the content, not on its storage";
}

TEST(Brick, WritesKeepThePaintOfOtherCells) {
    BrickIndices solid, paint;
    solid.fill(3);
    paint.fill(paintByte(2, 7));
    VoxelGrid grid(glm::ivec3(8));
    grid.setBrick({0, 0, 0}, makeBrick(solid, &paint));
    GridWriter(grid).set({1, 2, 3}, 4);
    const Brick& after = *grid.brickAt({0, 0, 0});
    for (int i = 0; i < kBrickVoxels; ++i)
        ASSERT_EQ(after.paintAt(i), voxelInBrick(i) == glm::ivec3(1, 2, 3) ? 0 : paintByte(2, 7));
}

TEST(Brick, PaintBytesHoldColourAndWeight) {
    EXPECT_EQ(paintSteps(0), 0);
    for (int color = 1; color <= kPaintColors; ++color)
        for (int steps = 1; steps <= kPaintSteps; ++steps) {
            const uint8_t byte = paintByte(color, steps);
            ASSERT_NE(byte, 0);
            ASSERT_EQ(paintColor(byte), color);
            ASSERT_EQ(paintSteps(byte), steps);
        }
}

}  // namespace
}  // namespace rubble
