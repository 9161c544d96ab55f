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
    const auto corner = [&] { return mirror.directory().low() * ShadowDirectory::kSectorCells; };
    const auto low = [&] { return mirror.occupiedLow() + corner(); };
    const auto high = [&] { return mirror.occupiedHigh() + corner(); };
    EXPECT_EQ(mirror.occupiedLow(), mirror.occupiedHigh());
    mirror.apply({patchWith({1, 0, 2}, {1 + 4 * 2 + 16 * 3})}, false);
    EXPECT_EQ(low(), glm::ivec3(16 + 4, 8, 32 + 12));
    EXPECT_EQ(high(), glm::ivec3(16 + 8, 12, 32 + 16));
    mirror.apply({patchWith({0, 0, 2}, {3 + 4 * 1 + 16 * 0, 2 + 4 * 3 + 16 * 3})}, false);
    EXPECT_EQ(low(), glm::ivec3(8, 4, 32));
    EXPECT_EQ(high(), glm::ivec3(24, 16, 48));
    mirror.apply({{{1, 0, 2}, nullptr}}, false);
    EXPECT_EQ(high(), glm::ivec3(16, 16, 48)) << "it shrinks";
    EXPECT_EQ(low(), glm::ivec3(8, 4, 32));
    mirror.apply({patchWith({-1, 0, 2}, {0})}, false);
    EXPECT_EQ(low(), glm::ivec3(-16, 0, 32)) << "the directory has moved";
    EXPECT_EQ(high(), glm::ivec3(16, 16, 48));
    mirror.apply({patchWith({5, 5, 5}, {0})}, true);
    EXPECT_EQ(mirror.occupiedHigh() - mirror.occupiedLow(), glm::ivec3(4)) << "another level";
}

}  // namespace
}  // namespace rubble
