#include "runtime/core/index_map.h"

#include <gtest/gtest.h>

#include <map>

#include "runtime/core/random.h"

namespace rubble {
namespace {

TEST(IndexMap, FindsWhatAMapDoes) {
    Random random(1);
    IndexMap map;
    std::map<uint64_t, uint32_t> plain;
    EXPECT_EQ(map.find(7), IndexMap::kNone);
    for (uint32_t i = 0; i < 5000; ++i) {
        // keys that differ in high bits only, and neighbours
        const uint64_t key = uint64_t(random.below(3)) << 54 | uint64_t(random.below(500)) << 20 | random.below(4);
        const auto [place, isNew] = plain.try_emplace(key, i);
        EXPECT_EQ(map.find(key) == IndexMap::kNone, isNew);
        uint32_t& index = map[key];
        ASSERT_EQ(index, isNew ? IndexMap::kNone : place->second);
        index = place->second = i;
    }
    for (const auto& [key, index] : plain) EXPECT_EQ(map.find(key), index);
    map.clear();
    for (const auto& [key, index] : plain) EXPECT_EQ(map.find(key), IndexMap::kNone);
}

}  // namespace
}  // namespace rubble
