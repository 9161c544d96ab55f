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

/// The definition: the side of the largest cube without an occupied brick that ends with the next sector.
int sideAt(const SectorSurroundings& occupied, glm::ivec3 brick, int octant) {
    const auto isFree = [&](glm::ivec3 at) {
        for (int a = 0; a < 3; ++a) {
            const bool isDown = octant >> a & 1;
            at[a] = isDown ? brick[a] - at[a] : brick[a] + at[a];
            if (isDown ? at[a] < -4 : at[a] > 7) return false;
        }
        return !isOccupied(occupied, at);
    };
    for (int side = 0;; ++side)
        for (int i = 0; i < (side + 1) * (side + 1); ++i)  // the outermost layer of the next larger cube
            for (int face = 0; face < 3; ++face) {
                glm::ivec3 at(side);
                at[(face + 1) % 3] = i % (side + 1);
                at[(face + 2) % 3] = i / (side + 1);
                if (!isFree(at)) return side;
            }
}

TEST(PageSkips, AreTheLargestEmptyCubesUpToTheNextSector) {
    Random random(4);
    for (int round = 0; round < 60; ++round) {
        SectorSurroundings occupied{};
        for (int i = 0; i < round; ++i) occupied[random.below(27)] |= SectorBricks(1) << random.below(64);
        const std::array<uint32_t, 64> skips = pageSkips(occupied);
        for (int i = 0; i < 64; ++i)
            for (int octant = 0; octant < 8; ++octant)
                EXPECT_EQ(int(skips[size_t(i)] >> (4 * octant) & 15),
                          sideAt(occupied, {i & 3, i >> 2 & 3, i >> 4}, octant))
                    << "round " << round << ", brick " << i << ", octant " << octant;
    }
}

}  // namespace
}  // namespace rubble
