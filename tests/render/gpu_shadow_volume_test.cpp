#include "render/scene/gpu_shadow_volume.h"

#include <algorithm>

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

/// 8x8 bricks at the origin.
std::vector<ShadowPatch> smallLevel() {
    std::vector<ShadowPatch> level;
    for (int i = 0; i < 64; ++i) level.push_back(patchWith({i & 7, 0, i >> 3}, {0}));
    return level;
}

TEST_F(GpuShadowVolumeTest, ABrickFarAwayTakesNoRoomFromTheLevelInAnyOrder) {
    const ShadowPatch stray = patchWith({3125, 0, 3125}, {0});
    std::vector<ShadowPatch> both = smallLevel();
    both.insert(both.begin(), stray);
    const std::vector<std::vector<ShadowPatch>> orders[] = {
        {smallLevel(), {stray}}, {{stray}, smallLevel()}, {both}, {{both.rbegin(), both.rend()}}};
    for (const auto& publications : orders) {
        GpuShadowVolume mirror;
        for (const std::vector<ShadowPatch>& patches : publications) mirror.apply(patches, false);
        const ShadowDirectory& directory = mirror.directory();
        for (const ShadowPatch& patch : smallLevel()) EXPECT_TRUE(directory.holds(patch.brick));
        EXPECT_EQ(directory.dense().bricks, 64) << "rays are as fast as without it";
        EXPECT_TRUE(directory.holds(stray.brick)) << "alone it costs a table of one sector";
    }
}

TEST_F(GpuShadowVolumeTest, WhatIsFarthestFromTheLevelHasNoRoomInAnyOrder) {
    std::vector<ShadowPatch> all = smallLevel();
    for (int i = 0; i < 40; ++i) {
        const int away = 1000 + 200 * i;
        all.push_back(patchWith({i & 1 ? away : -away, 0, i & 2 ? away : -away}, {0}));
    }
    std::vector<bool> expected;
    for (int order = 0; order < 3; ++order) {
        std::vector<ShadowPatch> patches = all;
        if (order) std::reverse(patches.begin(), patches.end());
        GpuShadowVolume mirror;
        if (order < 2)
            mirror.apply(patches, false);
        else
            for (const ShadowPatch& patch : patches) mirror.apply({patch}, false);
        const ShadowDirectory& directory = mirror.directory();
        std::vector<bool> held;
        for (const ShadowPatch& patch : all) held.push_back(directory.holds(patch.brick));
        EXPECT_TRUE(std::is_sorted(held.rbegin(), held.rend())) << "the nearest are in";
        EXPECT_TRUE(held[64 + 2]);
        EXPECT_FALSE(held[64 + 3]);
        EXPECT_EQ(directory.beyond(), std::count(held.begin(), held.end(), false));
        if (expected.empty()) expected = held;
        EXPECT_EQ(held, expected) << "order " << order;
    }
}

TEST_F(GpuShadowVolumeTest, WhatHadNoRoomHasItWhenTheRestIsGone) {
    GpuShadowVolume mirror;
    const ShadowDirectory& directory = mirror.directory();
    const glm::ivec3 near(3000, 0, 3000), far(-3000, 0, -3000), farther(-9000, 0, 4000);
    std::vector<ShadowPatch> patches = smallLevel();
    for (const glm::ivec3 brick : {far, near, farther}) patches.push_back(patchWith(brick, {5}));
    mirror.apply(patches, false);
    EXPECT_TRUE(directory.holds(near));
    EXPECT_FALSE(directory.holds(far));
    EXPECT_EQ(directory.beyond(), 2);
    const uint64_t written = directory.writtenTexels();
    for (int i = 1; i < 20; ++i)  // it flies on, out there
        mirror.apply({patchWith(farther - glm::ivec3(i, 0, 0), {5}), {farther - glm::ivec3(i - 1, 0, 0), nullptr}},
                     false);
    EXPECT_EQ(directory.writtenTexels(), written);
    EXPECT_EQ(directory.beyond(), 2);
    mirror.apply({{near, nullptr}}, false);
    EXPECT_TRUE(directory.holds(far));
    EXPECT_EQ(directory.find(far).occupied, uint64_t(1) << 5);
    EXPECT_EQ(directory.beyond(), 1);
    mirror.apply({{farther - glm::ivec3(19, 0, 0), nullptr}}, false);
    EXPECT_EQ(directory.beyond(), 0);
}

TEST_F(GpuShadowVolumeTest, ALevelThatComesLaterAndFarAwayHasTheRoom) {
    GpuShadowVolume mirror;
    const ShadowDirectory& directory = mirror.directory();
    mirror.apply({patchWith({0, 0, 0}, {0}), patchWith({2, 0, 0}, {0}), patchWith({9000, 0, 9000}, {0})}, false);
    std::vector<ShadowPatch> level = smallLevel();
    for (ShadowPatch& patch : level) patch.brick += glm::ivec3(9000, 0, 9000);
    mirror.apply(level, false);
    for (const ShadowPatch& patch : level) EXPECT_TRUE(directory.holds(patch.brick));
    EXPECT_EQ(directory.dense().bricks, 64);
}

}  // namespace
}  // namespace rubble
