#include "render/scene/gpu_shadow_volume.h"

#include "tests/render/gl_fixture.h"

namespace rubble {
namespace {

class GpuShadowVolumeTest : public GlTest {};

ShadowPatch patchWith(glm::ivec3 brick, std::initializer_list<int> words) {
    ShadowWords cells{};
    for (const int word : words) cells[size_t(word)] = 1;
    return {brick, makeShadowBrick(cells)};
}

TEST_F(GpuShadowVolumeTest, OccupiedBoundsFollowTheWords) {
    GpuShadowVolume mirror;
    const ShadowDirectory::Part& part = mirror.directory().dense();
    EXPECT_EQ(part.occupiedLow(), part.occupiedHigh());
    mirror.apply({patchWith({1, 0, 2}, {1 + 4 * 2 + 16 * 3})}, false);
    EXPECT_EQ(part.occupiedLow(), glm::ivec3(16 + 4, 8, 32 + 12));
    EXPECT_EQ(part.occupiedHigh(), glm::ivec3(16 + 8, 12, 32 + 16));
    mirror.apply({patchWith({0, 0, 2}, {3 + 4 * 1 + 16 * 0, 2 + 4 * 3 + 16 * 3})}, false);
    EXPECT_EQ(part.occupiedLow(), glm::ivec3(8, 4, 32));
    EXPECT_EQ(part.occupiedHigh(), glm::ivec3(24, 16, 48));
    mirror.apply({{{1, 0, 2}, nullptr}}, false);
    EXPECT_EQ(part.occupiedHigh(), glm::ivec3(16, 16, 48)) << "it shrinks";
    EXPECT_EQ(part.occupiedLow(), glm::ivec3(8, 4, 32));
    mirror.apply({patchWith({-1, 0, 2}, {0}), patchWith({-2, 0, 2}, {0})}, false);
    const glm::ivec3 corner = part.low * 64;
    EXPECT_EQ(part.occupiedLow() + corner, glm::ivec3(-32, 0, 32)) << "relative to the box, which has moved";
    EXPECT_EQ(part.occupiedHigh() + corner, glm::ivec3(16, 16, 48));
    mirror.apply({patchWith({5, 5, 5}, {0})}, true);
    EXPECT_EQ(part.occupiedHigh() - part.occupiedLow(), glm::ivec3(4)) << "another level";
}

TEST_F(GpuShadowVolumeTest, TheDensePartHoldsWhereMostBricksAreAndStaysThere) {
    GpuShadowVolume mirror;
    const ShadowDirectory& directory = mirror.directory();
    std::vector<ShadowPatch> level;
    for (int i = 0; i < 64; ++i) level.push_back(patchWith({i & 7, 0, i >> 3}, {0}));
    mirror.apply(level, true);
    EXPECT_EQ(directory.dense().size, glm::ivec3(2, 1, 2));
    EXPECT_EQ(directory.dense().bricks, 64);
    const uint64_t written = directory.writtenTexels();
    mirror.apply({patchWith({900, 40, 3}, {0}), patchWith({-900, 40, 3}, {0})}, false);
    EXPECT_EQ(directory.dense().size, glm::ivec3(2, 1, 2)) << "for two bricks far away";
    EXPECT_EQ(directory.paged().bricks, 2);
    EXPECT_LT(directory.writtenTexels() - written, 1000u);
    mirror.apply({{{900, 40, 3}, nullptr}, {{-900, 40, 3}, nullptr}}, false);
    EXPECT_EQ(directory.paged().bricks, 0);
    EXPECT_EQ(directory.paged().size, glm::ivec3(0)) << "its table goes";
    for (ShadowPatch& patch : level) patch.brick.x += 16;
    level.push_back(patchWith({16, 4, 0}, {0}));
    mirror.apply(level, false);
    EXPECT_EQ(directory.dense().size, glm::ivec3(6, 2, 2)) << "more is outside than inside";
    EXPECT_EQ(directory.dense().bricks, 129);
    for (const ShadowPatch& patch : level) EXPECT_TRUE(directory.find(patch.brick).occupied);
}

}  // namespace
}  // namespace rubble
