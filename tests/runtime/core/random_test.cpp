#include "runtime/core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace rubble {
namespace {

TEST(Random, GivesTheReferenceSequence) {
    // What the reference implementation's demo prints for seed 42, stream 54 (pcg-random.org).
    Random random(42, 54);
    const std::array<uint32_t, 6> expected = {0xa15c02b7, 0x7b47f409, 0xba1d3330, 0x83d2f293, 0xbfa4784b, 0xcbed606e};
    for (const uint32_t value : expected) EXPECT_EQ(random.next(), value);
}

TEST(Random, StaysInRangeAndReachesItsEnds) {
    Random random(7);
    std::set<int> seen;
    for (int i = 0; i < 1000; ++i) {
        const int value = random.between(-3, 4);
        ASSERT_GE(value, -3);
        ASSERT_LE(value, 4);
        seen.insert(value);
        const float unit = random.unit();
        ASSERT_GE(unit, 0.0f);
        ASSERT_LT(unit, 1.0f);
    }
    EXPECT_EQ(seen.size(), 8u);
}

TEST(HashCell, SpreadsNeighbours) {
    std::set<uint32_t> seen;
    for (int z = 0; z < 32; ++z)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) seen.insert(hashCell(x, y, z));
    EXPECT_GT(seen.size(), 32768u - 8u);
}

}  // namespace
}  // namespace rubble
