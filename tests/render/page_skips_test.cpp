#include "render/scene/page_skips.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>

#include "runtime/core/random.h"

namespace rubble {
namespace {

/// A brick by its place from the low corner of the sector in the middle.
bool isOccupied(const SectorSurroundings& occupied, glm::ivec3 brick) {
    const glm::ivec3 sector = (brick >> 2) + 1, in = brick & 3;
    return occupied[size_t(sector.x + 3 * sector.y + 9 * sector.z)] >> (in.x + 4 * in.y + 16 * in.z) & 1;
}

/// Whether a box that begins with a brick is empty and ends with the next sector.
bool isEmptyBox(const SectorSurroundings& occupied, glm::ivec3 brick, int octant, glm::ivec3 size) {
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                glm::ivec3 at(x, y, z);
                for (int a = 0; a < 3; ++a) {
                    const bool isDown = octant >> a & 1;
                    at[a] = isDown ? brick[a] - at[a] : brick[a] + at[a];
                    if (isDown ? at[a] < -4 : at[a] > 7) return false;
                }
                if (isOccupied(occupied, at)) return false;
            }
    return true;
}

double harmonicMean(glm::dvec3 size) {
    return 3.0 / (1.0 / size.x + 1.0 / size.y + 1.0 / size.z);
}

/// The definition: the largest harmonic mean of the sides of all empty boxes.
double bestMean(const SectorSurroundings& occupied, glm::ivec3 brick, int octant) {
    double best = 0.0;
    const auto sides = {1, 2, 3, 4, 6, 8};
    for (const int z : sides)
        for (const int y : sides)
            for (const int x : sides) {
                if (harmonicMean({x, y, z}) <= best) continue;
                if (!isEmptyBox(occupied, brick, octant, {x, y, z})) break;
                best = harmonicMean({x, y, z});
            }
    return best;
}

TEST(PageSkips, AreEmptyBoxesOfTheLargestHarmonicMeanUpToTheNextSector) {
    Random random(4);
    for (int round = 0; round < 24; ++round) {
        SectorSurroundings occupied{};
        for (int i = 0; i < 3 * round; ++i) occupied[random.below(27)] |= SectorBricks(1) << random.below(64);
        std::array<BrickSkips, 64> skips{};
        updatePageSkips(occupied, 0xff, skips);
        for (int i = 0; i < 64; ++i)
            for (int octant = 0; octant < 8; ++octant) {
                const glm::ivec3 brick(i & 3, i >> 2 & 3, i >> 4);
                glm::ivec3 size;
                for (int a = 0; a < 3; ++a) size[a] = int(skips[size_t(i)][size_t(a)] >> (4 * octant) & 15);
                SCOPED_TRACE("round " + std::to_string(round) + ", brick " + std::to_string(i) + ", octant " +
                             std::to_string(octant));
                if (isOccupied(occupied, brick)) {
                    EXPECT_EQ(size, glm::ivec3(0));
                    continue;
                }
                ASSERT_GT(size.x * size.y * size.z, 0);
                EXPECT_TRUE(isEmptyBox(occupied, brick, octant, size));
                EXPECT_NEAR(harmonicMean(size), bestMean(occupied, brick, octant), 1e-9);
            }
    }
}

TEST(PageSkips, OfOctantsThatAreNotNamedStay) {
    SectorSurroundings occupied{};
    std::array<BrickSkips, 64> skips{}, all{};
    updatePageSkips(occupied, 0xff, skips);
    const uint32_t before = skips[0][0];
    occupied[14] = ~SectorBricks(0);  // the next sector up x
    updatePageSkips(occupied, 0xff, all);
    updatePageSkips(occupied, 0x0f, skips);
    EXPECT_EQ(skips[0][0], (all[0][0] & 0xffffu) | (before & 0xffff0000u));
}

}  // namespace
}  // namespace rubble
