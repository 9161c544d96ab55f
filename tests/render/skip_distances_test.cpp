#include "render/scene/skip_distances.h"

#include <gtest/gtest.h>

#include "runtime/core/random.h"

namespace rubble {
namespace {

/// The definition: the side of the largest cube without an occupied sector.
int sideAt(const std::vector<uint8_t>& occupied, glm::ivec3 size, glm::ivec3 sector, int octant) {
    const auto isOccupied = [&](glm::ivec3 p) {
        for (int a = 0; a < 3; ++a)
            if (p[a] < 0 || p[a] >= size[a]) return false;
        return occupied[(size_t(p.z) * size_t(size.y) + size_t(p.y)) * size_t(size.x) + size_t(p.x)] != 0;
    };
    for (int side = 0; side < SkipDistances::kMaxDistance; ++side)
        for (int i = 0; i < (side + 1) * (side + 1); ++i)  // the outermost layer of the next larger cube
            for (int face = 0; face < 3; ++face) {
                glm::ivec3 at(side);
                at[(face + 1) % 3] = i % (side + 1);
                at[(face + 2) % 3] = i / (side + 1);
                for (int a = 0; a < 3; ++a) at[a] = octant >> a & 1 ? -at[a] : at[a];
                if (isOccupied(sector + at)) return side;
            }
    return SkipDistances::kMaxDistance;
}

TEST(SkipDistances, AreMaximalAfterEveryUpdate) {
    Random random(3);
    const glm::ivec3 size(24, 20, 28);
    SkipDistances cubes;
    cubes.reset(size);
    std::vector<uint8_t> occupied(size_t(size.x * size.y * size.z));
    std::vector<uint32_t> known(occupied.size(), ~0u);
    for (int round = 0; round < 12; ++round) {
        for (int i = 0; i < 1 + round * 3; ++i) {
            const glm::ivec3 sector(random.below(uint32_t(size.x)), random.below(uint32_t(size.y)),
                                    random.below(uint32_t(size.z)));
            uint8_t& at = occupied[cubes.indexOf(sector)];
            at = random.below(3) ? 1 : 0;
            cubes.set(sector, at);
        }
        for (const size_t index : cubes.update()) known[index] = cubes.at(index);
        size_t wrong = 0;
        for (size_t i = size_t(round); i < occupied.size(); i += 37) {
            const int n = int(i);
            const glm::ivec3 sector(n % size.x, n / size.x % size.y, n / size.x / size.y);
            wrong += known[i] != cubes.at(i);
            for (int octant = 0; octant < 8; ++octant)
                wrong += int(cubes.at(i) >> (4 * octant) & 15) != sideAt(occupied, size, sector, octant);
        }
        EXPECT_EQ(wrong, 0u) << "round " << round;
    }
}

TEST(SkipDistances, OfABoxThatMovesGrowsAndShrinksAreThoseOfANewOne) {
    Random random(4);
    const auto below = [&](int limit) {
        return glm::ivec3(random.below(uint32_t(limit)), random.below(uint32_t(limit)), random.below(uint32_t(limit)));
    };
    for (int round = 0; round < 40; ++round) {
        const glm::ivec3 core = 1 + below(8), low = -below(20), size = core - low + below(20), nextLow = -below(20),
                         nextSize = core - nextLow + below(20);
        SkipDistances moved, fresh;  // sectors 0 to `core` of the world are in both boxes
        moved.reset(size);
        fresh.reset(nextSize);
        for (int i = 0; i < 6; ++i) {
            const glm::ivec3 sector = below(8) % core;
            moved.set(sector - low, true);
            fresh.set(sector - nextLow, true);
        }
        moved.update();
        fresh.update();
        moved.move(nextLow - low, nextSize);
        size_t wrong = 0;
        const auto expectEqual = [&] {
            for (size_t i = 0; i < size_t(nextSize.x * nextSize.y * nextSize.z); ++i)
                wrong += moved.at(i) != fresh.at(i);
        };
        expectEqual();
        moved.set(nextSize / 2, true);  // and it goes on from there
        fresh.set(nextSize / 2, true);
        moved.update();
        fresh.update();
        expectEqual();
        EXPECT_EQ(wrong, 0u) << "round " << round;
    }
}

TEST(SkipDistances, CostFollowsTheChange) {
    SkipDistances cubes;
    cubes.reset({600, 10, 600});
    cubes.set({20, 3, 20}, true);
    cubes.set({590, 3, 580}, true);
    EXPECT_LE(cubes.update().size(), size_t(2 * 29 * 29 * 29)) << "two changes far apart";
    cubes.set({20, 3, 20}, true);
    EXPECT_TRUE(cubes.update().empty()) << "nothing new";
}

}  // namespace
}  // namespace rubble
