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
    EXPECT_EQ(mirror.occupiedLow(), mirror.occupiedHigh());
    mirror.apply({patchWith({1, 0, 2}, {1 + 4 * 2 + 16 * 3})}, false);
    EXPECT_EQ(mirror.occupiedLow(), glm::ivec3(16 + 4, 8, 32 + 12));
    EXPECT_EQ(mirror.occupiedHigh(), glm::ivec3(16 + 8, 12, 32 + 16));
    mirror.apply({patchWith({0, 0, 2}, {3 + 4 * 1 + 16 * 0, 2 + 4 * 3 + 16 * 3})}, false);
    EXPECT_EQ(mirror.occupiedLow(), glm::ivec3(8, 4, 32));
    EXPECT_EQ(mirror.occupiedHigh(), glm::ivec3(24, 16, 48));
    mirror.apply({{{1, 0, 2}, nullptr}}, false);
    EXPECT_EQ(mirror.occupiedHigh(), glm::ivec3(16, 16, 48)) << "it shrinks";
    EXPECT_EQ(mirror.occupiedLow(), glm::ivec3(8, 4, 32));
    mirror.apply({patchWith({-1, 0, 2}, {0})}, false);
    const glm::ivec3 corner = mirror.directory().low() * 64;
    EXPECT_EQ(mirror.occupiedLow() + corner, glm::ivec3(-16, 0, 32)) << "relative to the directory, which has moved";
    EXPECT_EQ(mirror.occupiedHigh() + corner, glm::ivec3(16, 16, 48));
    mirror.apply({patchWith({5, 5, 5}, {0})}, true);
    EXPECT_EQ(mirror.occupiedHigh() - mirror.occupiedLow(), glm::ivec3(4)) << "another level";
}

}  // namespace
}  // namespace rubble
