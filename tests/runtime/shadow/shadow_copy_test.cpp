#include "runtime/shadow/shadow_copy.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

ShadowBrickRef brickOf(uint64_t cells) {
    ShadowWords words{};
    words[0] = cells;
    return makeShadowBrick(words);
}

std::vector<glm::ivec3> bricksOf(const std::vector<BrickPlace>* places) {
    std::vector<glm::ivec3> out;
    for (const BrickPlace& place : *places) out.push_back(place.brick());
    return out;
}

TEST(ShadowChange, SaysWhichWordsAndHowManyCells) {
    const ShadowBrickRef one = brickOf(0b0110), other = brickOf(0b1010);
    EXPECT_EQ(changeBetween(one.get(), other.get()).words, 1u);
    EXPECT_EQ(changeBetween(one.get(), other.get()).cells, 2u);
    EXPECT_EQ(changeBetween(nullptr, one.get()).cells, 2u);
    EXPECT_EQ(changeBetween(one.get(), nullptr).words, 1u);
    EXPECT_EQ(changeBetween(one.get(), one.get()).words, 0u);
    EXPECT_EQ(changeBetween(nullptr, nullptr).cells, 0u);
}

TEST(ShadowCopy, ListsWhatChangedSinceAVersion) {
    ShadowCopy copy;
    const glm::ivec3 low(-1, 0, 0), high(4, 0, 2);
    EXPECT_TRUE(copy.changed(0)->empty());
    copy.follow(std::vector<ShadowPatches>{{1, true, {{high, brickOf(1)}, {low, brickOf(2)}}}});
    const uint64_t first = copy.version();
    EXPECT_EQ(bricksOf(copy.changed(0)), (std::vector<glm::ivec3>{low, high}));
    EXPECT_TRUE(copy.changed(first)->empty());
    copy.follow(std::vector<ShadowPatches>{{2, false, {{low, brickOf(3)}}}, {3, false, {{high, nullptr}}}});
    EXPECT_EQ(bricksOf(copy.changed(first)), (std::vector<glm::ivec3>{low, high}));
    EXPECT_EQ(bricksOf(copy.changed(first + 1)), std::vector<glm::ivec3>{high});
    EXPECT_EQ(bricksOf(copy.changed(0)), std::vector<glm::ivec3>{low}) << "the other is empty";
    EXPECT_EQ(copy.find(BrickPlace(low))->cells(0), 3u);
    EXPECT_EQ(copy.find(BrickPlace(high)), nullptr);
    EXPECT_EQ(copy.changed(copy.version() + 1), nullptr) << "it is not yet";
    copy.follow(std::vector<ShadowPatches>{{4, true, {}}});
    EXPECT_EQ(copy.changed(first), nullptr) << "all was replaced";
    EXPECT_TRUE(copy.changed(0)->empty());
}

}  // namespace
}  // namespace rubble
