#include "runtime/core/bounds_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "runtime/core/random.h"

namespace rubble {
namespace {

WorldBox randomBox(Random& random, double spread) {
    WorldBox box;
    for (int a = 0; a < 3; ++a) {
        box.low[a] = (random.unit() - 0.5) * spread;
        box.high[a] = box.low[a] + random.unit() * 3.0;
    }
    return box;
}

std::vector<uint32_t> found(const BoundsTree& tree, const WorldBox& around) {
    std::vector<uint32_t> out;
    tree.find([&](const WorldBox& box) { return box.overlaps(around); }, [&](uint32_t item) { out.push_back(item); });
    std::sort(out.begin(), out.end());
    return out;
}

TEST(BoundsTree, FindsTheSameAsBruteForce) {
    Random random(7);
    BoundsTree tree;
    std::map<uint32_t, WorldBox> boxes;
    for (int i = 0; i < 4000; ++i) {
        const uint32_t item = random.below(600);
        if (random.below(4) == 0) {
            tree.remove(item);
            boxes.erase(item);
        } else {
            tree.update(item, boxes[item] = randomBox(random, 60.0));
        }
        if (i % 20) continue;
        const WorldBox around = randomBox(random, 60.0);
        const std::vector<uint32_t> near = found(tree, around);
        EXPECT_TRUE(std::adjacent_find(near.begin(), near.end()) == near.end()) << "each once";
        for (const auto& [number, box] : boxes) {
            const bool isFound = std::binary_search(near.begin(), near.end(), number);
            EXPECT_TRUE(isFound || !box.overlaps(around)) << number;
            const WorldBox wide{around.low - 2.0, around.high + 2.0};
            EXPECT_TRUE(!isFound || box.overlaps(wide)) << number << " is far away";
        }
        for (const uint32_t each : near) EXPECT_TRUE(boxes.contains(each));
    }
}

TEST(BoundsTree, StaysShallowForSortedInsertions) {
    BoundsTree tree;
    for (uint32_t i = 0; i < 4096; ++i) tree.update(i, {glm::dvec3(i, 0, 0), glm::dvec3(i + 0.9, 1, 1)});
    EXPECT_LT(tree.depth(), 4 * 12);
}

TEST(BoundsTree, StaysShallowForManyBoxesInOnePlace) {
    for (const double jitter : {0.0, 1e-9, 0.05, 0.5}) {
        Random random(1);
        BoundsTree tree;
        for (uint32_t i = 0; i < 20000; ++i) {
            const glm::dvec3 low = jitter * glm::dvec3(random.unit(), random.unit(), random.unit());
            tree.update(i, {low, low + 1.0});
        }
        EXPECT_LT(tree.depth(), 4 * 15) << jitter;
        for (uint32_t i = 0; i < 20000; i += 2) tree.remove(i);
        EXPECT_LT(tree.depth(), 4 * 15) << jitter;
        EXPECT_EQ(found(tree, {glm::dvec3(0), glm::dvec3(1)}).size(), 10000u);
    }
}

TEST(BoundsTree, NotANumberIsNotStored) {
    BoundsTree tree;
    tree.update(3, {glm::dvec3(0), glm::dvec3(1)});
    tree.update(3, {glm::dvec3(std::nan("")), glm::dvec3(1)});
    tree.remove(9);
    const double all = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(found(tree, {glm::dvec3(-all), glm::dvec3(all)}).empty());
    tree.update(3, {glm::dvec3(0), glm::dvec3(1)});
    EXPECT_EQ(found(tree, {glm::dvec3(-all), glm::dvec3(all)}), std::vector<uint32_t>{3});
}

}  // namespace
}  // namespace rubble
