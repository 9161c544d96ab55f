#include "runtime/destruction/brush.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/destruction/reference_algorithms.h"

namespace rubble {
namespace {

using Point = glm::dvec3;

double unit(Random& random) {
    return double(random.unit()) * 2.0 - 1.0;
}

Point randomPoint(Random& random, double scale) {
    const double x = unit(random), y = unit(random), z = unit(random);
    return Point(x, y, z) * scale;
}

glm::dquat randomRotation(Random& random) {
    const double w = unit(random), x = unit(random), y = unit(random), z = unit(random);
    return glm::normalize(glm::dquat(w, x, y, z + 1e-3));
}

/// Signed distances to the surfaces, in cells.
double toSphere(Point p, Point center, double radius) {
    return glm::length(p - center) - radius;
}
double toCapsule(Point p, Point a, Point b, double radius) {
    const double length2 = glm::dot(b - a, b - a);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
    return glm::length(p - a - (b - a) * t) - radius;
}
double toBox(Point p, Point center, Point half, glm::dquat rotation) {
    const Point q = glm::abs(glm::conjugate(rotation) * (p - center)) - half;
    return std::max({q.x, q.y, q.z});
}

/// Compares every cell of a grid of 5x5x5 bricks. Cells within the rounding of the brush (1/64 cell) are not tested.
template <class F>
void expectTouched(const Brush& brush, F&& distance, const std::string& what) {
    const glm::ivec3 bricks(5);
    const CellBox range = brushBricks(brush, bricks);
    for (int z = 0; z < bricks.z; ++z)
        for (int y = 0; y < bricks.y; ++y)
            for (int x = 0; x < bricks.x; ++x) {
                const glm::ivec3 brick(x, y, z);
                const bool inRange =
                    glm::all(glm::greaterThanEqual(brick, range.low)) && glm::all(glm::lessThan(brick, range.high));
                const BrickBits bits = inRange ? brushBits(brush, brick, brush.radii[0]) : BrickBits{};
                for (int i = 0; i < kBrickVoxels; ++i) {
                    const bool isTouched = hasVoxel(bits, i);
                    const double d = distance(Point(brick * kBrickSize + voxelInBrick(i)) + 0.5);
                    ASSERT_TRUE(isTouched == (d < 0.0) || std::abs(d) <= 1.0 / 64)
                        << what << ", cell at distance " << d;
                }
            }
}

TEST(Brush, TouchesTheCellsWithinTheExactDistance) {
    Random random(1);
    for (int i = 0; i < 80 && !HasFatalFailure(); ++i) {
        const Point a = randomPoint(random, 24.0) + 20.0, b = randomPoint(random, 24.0) + 20.0;
        const Point half = glm::abs(randomPoint(random, 14.0)) + 0.1;
        const double radius = 0.3 + 14.0 * random.unit();
        const glm::dquat rotation = randomRotation(random);
        expectTouched(
            sphereBrush(a, {radius, 0, 0}), [&](Point p) { return toSphere(p, a, radius); }, "sphere");
        expectTouched(
            capsuleBrush(a, b, {radius, 0, 0}), [&](Point p) { return toCapsule(p, a, b, radius); }, "capsule");
        expectTouched(
            boxBrush(a, half, rotation, Hardness::Hard), [&](Point p) { return toBox(p, a, half, rotation); }, "box");
    }
}

TEST(Brush, BricksHoldExactlyTheCellsWhoseCentresAreInside) {
    Random random(3);
    for (int i = 0; i < 60 && !HasFatalFailure(); ++i) {
        const Point a = randomPoint(random, 14.0) + 12.0, b = randomPoint(random, 14.0) + 12.0,
                    half = glm::abs(randomPoint(random, 12.0));
        // Axis-aligned boxes, and boxes rotated about one axis, take shorter code paths.
        const glm::dquat upright(1, 0, 0, 0), turned = glm::angleAxis(double(random.unit()), Point(0, 0, 1));
        const double radius = 12.0 * random.unit();
        for (Brush brush : {sphereBrush(a, {radius, radius, radius}), capsuleBrush(a, b, {radius, radius, radius}),
                            boxBrush(a, half, upright, Hardness::Hard), boxBrush(a, half, turned, Hardness::Hard),
                            boxBrush(a, half, randomRotation(random), Hardness::Hard),
                            boxBrush(glm::round(a), glm::round(half), upright, Hardness::Hard)}) {
            if (brush.kind == BrushKind::Box) brush.radii[0] = 128 * (i % 9 - 5);  // shrunk or grown
            for (int n = 0; n < 27; ++n) {
                const glm::ivec3 brick(n % 3, n / 3 % 3, n / 9);
                const BrickBits bits = brushBits(brush, brick, brush.radii[0]);
                for (int v = 0; v < kBrickVoxels; ++v) {
                    const glm::ivec3 cell = brick * kBrickSize + voxelInBrick(v);
                    const bool isInside = brushContains(
                        brush, {cell.x * 256 + 128, cell.y * 256 + 128, cell.z * 256 + 128}, brush.radii[0]);
                    ASSERT_EQ(hasVoxel(bits, v), isInside) << "kind " << int(brush.kind);
                }
            }
        }
    }
}

TEST(Brush, RadiiAreOrderedAndInvalidBrushesTouchNothing) {
    const Brush sphere = sphereBrush({4.5, 4.5, 4.5}, {2.0, 5.0, 0.0});
    EXPECT_EQ(sphere.radii[1], sphere.radii[0]);
    EXPECT_EQ(sphere.radii[2], kBrushEmptyRadius);
    EXPECT_EQ(brushBits(sphere, {0, 0, 0}, sphere.radii[2]), BrickBits{});
    const double nan = std::nan("");
    EXPECT_TRUE(brushBricks(sphereBrush({nan, 0, 0}, {1, 1, 1}), {9, 9, 9}).empty());
    EXPECT_TRUE(brushBricks(sphereBrush({0, 0, 0}, {nan, 0, 0}), {9, 9, 9}).empty());
    EXPECT_TRUE(brushBricks(boxBrush({0, 0, 0}, {1, nan, 1}, {1, 0, 0, 0}, Hardness::Hard), {9, 9, 9}).empty());
    EXPECT_TRUE(brushBricks(boxBrush({4, 4, 4}, {1, 1, 1}, {1, 0, 0, 0}, Hardness::Hard), {0, 0, 0}).empty());
}

TEST(Brush, FarAndHugeBrushesDoNotOverflow) {
    const double infinity = std::numeric_limits<double>::infinity();
    const Brush everything = sphereBrush({16, 16, 16}, {infinity, infinity, infinity});
    EXPECT_EQ(brushBricks(everything, {4, 4, 4}).high, glm::ivec3(4));
    EXPECT_EQ(brushBits(everything, {3, 3, 3}, everything.radii[0])[7], ~uint64_t(0));
    const Brush far = sphereBrush({1e30, -1e30, 5}, {4, 4, 4});
    EXPECT_TRUE(brushBricks(far, {512, 512, 512}).empty());
    const Brush needle = capsuleBrush({-1e9, 4.5, 4.5}, {1e9, 4.5, 4.5}, {0.6, 0.6, 0.6});
    EXPECT_EQ(brushBits(needle, {100, 0, 0}, needle.radii[0])[4], 0xffull << 32);
}

}  // namespace
}  // namespace rubble
