#include "runtime/core/wide_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "runtime/core/random.h"

namespace rubble {
namespace {

glm::dvec3 anywhere(Random& random, double spread) {
    const double x = double(random.unit()), y = double(random.unit()), z = double(random.unit());
    return (glm::dvec3(x, y, z) - 0.5) * spread;
}

/// Whether a ray passes within a distance through a box, in doubles.
bool meets(const WorldBox& box, glm::dvec3 origin, glm::dvec3 direction, double distance) {
    double enter = 0.0, leave = distance;
    for (int a = 0; a < 3; ++a) {
        if (direction[a] == 0.0) {
            if (origin[a] < box.low[a] || origin[a] > box.high[a]) return false;
            continue;
        }
        const double low = (box.low[a] - origin[a]) / direction[a], high = (box.high[a] - origin[a]) / direction[a];
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    return enter <= leave;
}

/// Rays between random points and along the axes find all boxes that they meet, in a tree of this many.
void testRays(uint32_t count, double spread, glm::dvec3 middle) {
    Random random(count);
    BoundsTree tree;
    std::vector<WorldBox> boxes;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 low = middle + anywhere(random, spread);
        boxes.push_back({low, low + anywhere(random, 3.0) + 1.5});
        tree.update(i, boxes.back());
    }
    const WideTree wide(tree);
    EXPECT_EQ(wide.items().size(), count);
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 origin = middle + anywhere(random, 1.5 * spread);
        glm::dvec3 direction = glm::normalize(middle + anywhere(random, spread) - origin);
        if (i % 4 == 0) direction = glm::dvec3(0.0), direction[i / 4 % 3] = i % 8 ? 1.0 : -1.0;
        const double distance = i % 3 ? 2.0 * spread : 0.3 * spread;
        ASSERT_TRUE(wide.isExactFor(origin));
        std::set<uint32_t> found;
        wide.findAlong(origin, direction, distance, [&](uint32_t item) {
            EXPECT_TRUE(found.insert(item).second) << "each once";
            return distance;
        });
        for (uint32_t item = 0; item < count; ++item) {
            EXPECT_TRUE(found.contains(item) || !meets(boxes[item], origin, direction, distance)) << item;
            const WorldBox around{boxes[item].low - 0.5, boxes[item].high + 0.5};
            EXPECT_TRUE(!found.contains(item) || meets(around, origin, direction, distance + 0.5)) << item;
        }
    }
}

TEST(WideTree, RaysFindAllBoxesThatTheyMeet) {
    for (const uint32_t count : {1u, 2u, 5u, 300u}) testRays(count, 60.0, {0, 0, 0});
    testRays(200, 15'000.0, {0, 0, 0});
    testRays(200, 60.0, {1e7, -3e6, 5e8});
}

TEST(WideTree, WhatIsTooFarForFloatsIsNotExact) {
    BoundsTree tree;
    EXPECT_TRUE(WideTree(tree).items().empty());
    WideTree(tree).findAlong({0, 0, 0}, {1, 0, 0}, 10.0, [](uint32_t) {
        ADD_FAILURE() << "there is nothing";
        return 0.0;
    });
    tree.update(3, {{0, 0, 0}, {1, 1, 1}});
    EXPECT_TRUE(WideTree(tree).isExactFor({1e4, 0, 0}));
    EXPECT_FALSE(WideTree(tree).isExactFor({1e6, 0, 0}));
    EXPECT_FALSE(WideTree(tree).isExactFor({0, NAN, 0}));
    tree.update(4, {{1e5, 0, 0}, {1e5 + 1, 1, 1}});
    EXPECT_FALSE(WideTree(tree).isExactFor({1, 1, 1}));
}

TEST(WideTree, NearerBoxesComeFirstAndWhatIsBehindTheBestIsLeftOut) {
    BoundsTree tree;
    for (uint32_t i = 0; i < 500; ++i) tree.update(i, {glm::dvec3(3 * i, 0, 0), glm::dvec3(3 * i + 1, 1, 1)});
    const WideTree wide(tree);
    std::vector<uint32_t> found;
    wide.findAlong({-5.0, 0.5, 0.5}, {1.0, 0.0, 0.0}, 1e4, [&](uint32_t item) {
        found.push_back(item);
        return 3.0 * item + 5.0;
    });
    EXPECT_EQ(found, std::vector<uint32_t>{0});
}

}  // namespace
}  // namespace rubble
