#include "render/scene/convex_polygon.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

ConvexPolygon square(glm::dvec2 low, double side) {
    return ConvexPolygon::around({low, low + glm::dvec2(side, 0), low + side, low + glm::dvec2(0, side)});
}

TEST(ConvexPolygon, IsTheHullOfPointsInAnyOrder) {
    const ConvexPolygon hull =
        ConvexPolygon::around({{1, 1}, {4, 0}, {0, 0}, {2, 3}, {2, 0}, {4, 4}, {0, 4}, {2, 4}, {0, 0}});
    EXPECT_EQ(hull.corners(), (std::vector<glm::dvec2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
    EXPECT_DOUBLE_EQ(hull.area(), 16.0);
}

TEST(ConvexPolygon, OfPointsInALineIsEmptyUntilItIsWidened) {
    const ConvexPolygon line = ConvexPolygon::around({{0, 0}, {1, 1}, {3, 3}, {2, 2}});
    EXPECT_TRUE(line.empty());
    EXPECT_DOUBLE_EQ(line.area(), 0.0);
    EXPECT_DOUBLE_EQ(line.widened(0.5).area(), 1.0 + 6.0) << "a square swept along the diagonal";
    EXPECT_TRUE(ConvexPolygon::around({}).widened(1.0).empty());
}

TEST(ConvexPolygon, IsClippedByARectangle) {
    const ConvexPolygon diamond = ConvexPolygon::around({{0, -2}, {2, 0}, {0, 2}, {-2, 0}});
    EXPECT_DOUBLE_EQ(diamond.clipped({-9, -9}, {9, 9}).area(), 8.0);
    EXPECT_DOUBLE_EQ(diamond.clipped({0, 0}, {9, 9}).area(), 2.0);
    EXPECT_DOUBLE_EQ(diamond.clipped({-1, -1}, {1, 1}).area(), 4.0);
    EXPECT_TRUE(diamond.clipped({5, 5}, {9, 9}).empty());
}

TEST(ConvexPolygon, OverlapsWhatItHasAnAreaInCommonWith) {
    const ConvexPolygon one = square({0, 0}, 2.0), diamond = ConvexPolygon::around({{3, 1}, {5, 3}, {3, 5}, {1, 3}});
    EXPECT_TRUE(one.overlaps(square({1, 1}, 3.0), 1e-6));
    EXPECT_TRUE(one.overlaps(square({0.5, 0.5}, 1.0), 1e-6)) << "inside";
    EXPECT_FALSE(one.overlaps(square({2, 0}, 2.0), 1e-6)) << "side by side";
    EXPECT_FALSE(one.overlaps(diamond, 1e-6)) << "their rectangles overlap";
    EXPECT_FALSE(one.overlaps(ConvexPolygon(), 1e-6));
}

}  // namespace
}  // namespace rubble
