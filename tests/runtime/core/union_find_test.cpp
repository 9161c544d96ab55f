#include "runtime/core/union_find.h"

#include <gtest/gtest.h>

#include "runtime/core/random.h"

namespace rubble {
namespace {

TEST(UnionFind, NamesEachSetByItsLowestMember) {
    constexpr uint32_t kMembers = 300;
    Random random(1);
    UnionFind<uint16_t> sets(kMembers / 2);
    sets.grow(kMembers);
    std::vector<uint32_t> plain(kMembers);
    for (uint32_t i = 0; i < kMembers; ++i) plain[i] = i;
    for (int i = 0; i < 250; ++i) {
        const uint32_t a = random.below(kMembers), b = random.below(kMembers);
        EXPECT_EQ(sets.unite(uint16_t(a), uint16_t(b)), plain[a] != plain[b]);
        const uint32_t low = std::min(plain[a], plain[b]), high = std::max(plain[a], plain[b]);
        std::replace(plain.begin(), plain.end(), high, low);
        for (uint32_t each = 0; each < kMembers; ++each) ASSERT_EQ(sets.root(uint16_t(each)), plain[each]);
    }
}

}  // namespace
}  // namespace rubble
