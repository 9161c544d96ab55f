#include "runtime/voxel/ray_walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "runtime/voxel/cell_walk.h"
#include "tests/runtime/voxel/ray_classes.h"

namespace rubble {
namespace {

using namespace ray_classes;

int raysPerClass() {
    return std::getenv("RUBBLE_LONG") ? 10'000'000 : 100'000;
}

/// The walk by single steps only.
CellHit plainWalk(const VoxelGrid& grid, const CellRay& ray) {
    CellWalk walk;
    for (bool inside = walk.start(ray, grid.size()); inside; inside = walk.step())
        if (grid.at(walk.cell())) return {true, walk.cell(), walk.t(), walk.axis(), walk.sign(), 0};
    return {};
}

void checkRay(const VoxelGrid& grid, const CellRay& ray) {
    const CellHit hit = walkRay(grid, ray);
    const CellHit plain = plainWalk(grid, ray);
    ASSERT_LE(hit.steps, 3 * kSize + 3);
    ASSERT_TRUE(hit.hit == plain.hit && hit.cell == plain.cell && hit.t == plain.t && hit.axis == plain.axis &&
                hit.sign == plain.sign)
        << "skipping empty bricks changed the walk";
    if (!isFinite(ray)) {
        ASSERT_FALSE(hit.hit) << "a hit from a NaN or an infinity";
        return;
    }
    const Slabs slabs(ray);
    const long double pierced = firstPierced(grid, ray, slabs);
    const long double extent =
        std::max({std::fabs(ray.origin.x), std::fabs(ray.origin.y), std::fabs(ray.origin.z), 16.0});
    const long double length =
        std::hypot((long double)ray.direction.x, (long double)ray.direction.y, (long double)ray.direction.z);
    // Half an ulp each for a difference and a quotient at the distance of the origin, and a margin of two.
    const long double tolerance = length > 0.0L ? extent * 0x1p-51L / length * 4.0L : 0.0L;
    if (!hit.hit) {
        ASSERT_EQ(pierced, HUGE_VALL) << "missed a pierced voxel";
        return;
    }
    ASSERT_TRUE(grid.at(hit.cell));
    if (std::isinf(hit.t)) {  // the hit is real, but no double can hold its t
        ASSERT_FALSE(slabs.cell(hit.cell).empty());
        ASSERT_LE(slabs.cell(hit.cell).low, pierced);
        return;
    }
    ASSERT_LE(hit.t, pierced + tolerance) << "an earlier voxel was pierced";
    ASSERT_GE(hit.t, 0.0);
    ASSERT_LE(hit.t, ray.tMax);
    // The ray touches the cell: at the reported t it is within the tolerance of the closed cell along each axis.
    for (int a = 0; a < 3; ++a) {
        const long double p = ray.origin[a] + (long double)ray.direction[a] * hit.t;
        ASSERT_GE(p, hit.cell[a] - extent * 0x1p-49L) << "axis " << a;
        ASSERT_LE(p, hit.cell[a] + 1 + extent * 0x1p-49L) << "axis " << a;
    }
    if (hit.axis >= 0) {
        const long double p = ray.origin[hit.axis] + (long double)ray.direction[hit.axis] * hit.t;
        ASSERT_NEAR(double(p - hit.cell[hit.axis]), hit.sign > 0 ? 1.0 : 0.0, double(extent * 0x1p-49L));
        ASSERT_LT(hit.sign * ray.direction[hit.axis], 0.0);
    } else {
        ASSERT_EQ(hit.t, 0.0);
    }
}

class RayWalk : public testing::TestWithParam<int> {};

TEST_P(RayWalk, AgreesWithExactSlabs) {
    const RayClass rayClass = RayClass(GetParam());
    Random random(7, uint64_t(GetParam()));
    const int rays = raysPerClass();
    constexpr int kRaysPerGrid = 1000;
    int hits = 0;
    for (int i = 0; i < rays; i += kRaysPerGrid) {
        const VoxelGrid grid = randomGrid(random, 1 << random.between(1, 9));
        for (int k = 0; k < kRaysPerGrid; ++k) {
            const CellRay ray = drawRay(rayClass, random);
            checkRay(grid, ray);
            ASSERT_FALSE(HasFatalFailure()) << text(ray);
            hits += walkRay(grid, ray).hit;
        }
    }
    if (rayClass == RayClass::NotANumber)
        EXPECT_EQ(hits, 0);
    else
        EXPECT_GT(hits, rays / 100);
}

INSTANTIATE_TEST_SUITE_P(Classes, RayWalk, testing::Range(0, int(RayClass::kCount)),
                         [](const auto& tested) { return kClassNames[size_t(tested.param)]; });

TEST(RayWalkShell, NoRayLeavesAShellOneVoxelThick) {
    VoxelGrid grid({kSize, kSize, kSize});
    {
        GridWriter writer(grid);
        for (int i = 0; i < kSize * kSize * kSize; ++i) {
            const glm::ivec3 c(i & 15, i >> 4 & 15, i >> 8);
            const glm::ivec3 far = kSize - 1 - c;
            if (std::min({c.x, c.y, c.z, far.x, far.y, far.z}) == 2) writer.set(c, 1);
        }
    }
    Random random(3);
    for (int i = 0; i < raysPerClass(); ++i) {
        CellRay ray{drawPoint(random, 3.0, kSize - 3.0), drawDirection(random), kInfinity};
        if (random.below(2))  // to an edge or corner of the shell, exactly or nearly
            for (int a = 0; a < 3; ++a) ray.direction[a] = random.between(2, kSize - 2) - ray.origin[a];
        if (random.below(2))
            for (int a = 0; a < 3; ++a) ray.origin[a] = random.between(3, kSize - 3);
        if (!random.below(4)) ray.direction[int(random.below(3))] = 0.0;
        if (ray.direction == glm::dvec3(0.0)) continue;
        ASSERT_TRUE(walkRay(grid, ray).hit) << text(ray);
    }
}

TEST(RayWalkRules, FacesBelongToTheCellThatTheRayEnters) {
    VoxelGrid grid({4, 4, 4});
    GridWriter(grid).set({2, 1, 1}, 1);
    const glm::dvec3 right(1, 0, 0), left(-1, 0, 0);
    EXPECT_TRUE(walkRay(grid, {{2.0, 1.5, 1.5}, right, 0.0}).hit);
    EXPECT_FALSE(walkRay(grid, {{2.0, 1.5, 1.5}, left, 9.0}).hit);
    EXPECT_TRUE(walkRay(grid, {{3.0, 1.5, 1.5}, left, 0.0}).hit);
    EXPECT_FALSE(walkRay(grid, {{3.0, 1.5, 1.5}, right, 9.0}).hit);
    EXPECT_TRUE(walkRay(grid, {{2.0, 1.5, 1.5}, {0, 0, 0}, 0.0}).hit);
    EXPECT_FALSE(walkRay(grid, {{3.0, 1.5, 1.5}, {0, 0, 0}, 9.0}).hit);
    const CellHit hit = walkRay(grid, {{-3.0, 1.5, 1.5}, right, 5.0});
    EXPECT_TRUE(hit.hit);
    EXPECT_EQ(hit.t, 5.0);
    EXPECT_EQ(hit.axis, 0);
    EXPECT_EQ(hit.sign, -1);
    EXPECT_FALSE(walkRay(grid, {{-3.0, 1.5, 1.5}, right, 4.999}).hit);
    EXPECT_FALSE(walkRay(grid, {{2.5, 1.5, 1.5}, right, -1.0}).hit);
    EXPECT_FALSE(walkRay(VoxelGrid(), {{0.0, 0.0, 0.0}, right, 1.0}).hit);
}

TEST(RayWalkRules, EmptySpaceIsSkipped) {
    VoxelGrid grid({1024, 64, 64});
    GridWriter(grid).set({1020, 33, 30}, 1);
    const CellHit hit = walkRay(grid, {{-5.0, 33.5, 30.5}, {1, 0, 0}, kInfinity});
    EXPECT_EQ(hit.cell, glm::ivec3(1020, 33, 30));
    EXPECT_EQ(hit.t, 1025.0);
    EXPECT_LE(hit.steps, 31 + 3 + 5);
}

}  // namespace
}  // namespace rubble
