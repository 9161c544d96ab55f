#include "runtime/voxel/ray_walk.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>
#include <string>

#include "runtime/core/random.h"
#include "runtime/voxel/cell_walk.h"

namespace rubble {
namespace {

constexpr int kSize = 16;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

int raysPerClass() {
    return std::getenv("RUBBLE_LONG") ? 10'000'000 : 100'000;
}

struct Interval {
    long double low, high;
    bool empty() const { return !(low <= high); }
};
Interval both(Interval a, Interval b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// Where a ray is inside each slab [k, k + 1] of each axis, in long double: 11 bits more than the walk has. A ray that runs
/// along a face pierces neither voxel; it is asked to find the higher one.
struct Slabs {
    explicit Slabs(const CellRay& ray) {
        for (int a = 0; a < 3; ++a)
            for (int k = 0; k < kSize; ++k) {
                const long double o = ray.origin[a], d = ray.direction[a];
                Interval& slab = at[size_t(a)][size_t(k)];
                if (d == 0.0L)
                    slab = o >= k && o < k + 1 ? Interval{0.0L, HUGE_VALL} : Interval{1.0L, 0.0L};
                else
                    slab = {std::max(0.0L, std::min((k - o) / d, (k + 1 - o) / d)), std::max((k - o) / d, (k + 1 - o) / d)};
            }
    }
    Interval cell(glm::ivec3 c) const { return both(both(at[0][size_t(c.x)], at[1][size_t(c.y)]), at[2][size_t(c.z)]); }
    std::array<std::array<Interval, kSize>, 3> at;
};

/// The earliest t at which the ray enters a solid voxel that it pierces by 1e-4 voxel or more; infinite if there is none.
long double firstPierced(const VoxelGrid& grid, const CellRay& ray, const Slabs& slabs) {
    const long double length = std::hypot((long double)ray.direction.x, (long double)ray.direction.y, (long double)ray.direction.z);
    long double first = HUGE_VALL;
    for (int z = 0; z < kSize; ++z) {
        if (slabs.at[2][size_t(z)].empty()) continue;
        for (int y = 0; y < kSize; ++y) {
            const Interval row = both(slabs.at[2][size_t(z)], slabs.at[1][size_t(y)]);
            if (row.empty() || row.low >= first) continue;
            for (int x = 0; x < kSize; ++x) {
                const Interval in = both(row, slabs.at[0][size_t(x)]);
                if (in.empty() || in.low >= first || !grid.at({x, y, z})) continue;
                if (length == 0.0L || (std::min<long double>(in.high, ray.tMax) - in.low) * length >= 1e-4L) first = in.low;
            }
        }
    }
    return first <= ray.tMax ? first : HUGE_VALL;
}

/// The walk without any leap.
CellHit plainWalk(const VoxelGrid& grid, const CellRay& ray) {
    CellWalk walk;
    for (bool inside = walk.start(ray, grid.size()); inside; inside = walk.step())
        if (grid.at(walk.cell())) return {true, walk.cell(), walk.t(), walk.axis(), walk.sign(), 0};
    return {};
}

VoxelGrid randomGrid(Random& random, int oneIn) {
    VoxelGrid grid({kSize, kSize, kSize});
    GridWriter writer(grid);
    const int emptyBrick = int(random.below(8));  // so that leaps happen
    for (int i = 0; i < kSize * kSize * kSize; ++i) {
        const glm::ivec3 cell(i & 15, i >> 4 & 15, i >> 8);
        const bool isEmpty = (cell.x >> 3) + (cell.y >> 3) * 2 + (cell.z >> 3) * 4 == emptyBrick;
        if (!random.below(uint32_t(oneIn)) && !isEmpty) writer.set(cell, 1);
    }
    return grid;
}

double draw(Random& random, double low, double high) {
    return low + (high - low) * double(random.unit());
}

glm::dvec3 drawPoint(Random& random, double low, double high) {
    glm::dvec3 p;
    for (int a = 0; a < 3; ++a) p[a] = draw(random, low, high);
    return p;
}

glm::dvec3 drawDirection(Random& random) {
    for (;;) {
        const glm::dvec3 d = drawPoint(random, -1.0, 1.0);
        const double square = glm::dot(d, d);
        if (square > 0.01 && square <= 1.0) return d / std::sqrt(square);
    }
}

glm::dvec3 drawCorner(Random& random) {
    glm::dvec3 p;
    for (int a = 0; a < 3; ++a) p[a] = random.between(0, kSize);
    return p;
}

enum class RayClass {
    AxisParallel,
    SignedZero,
    Denormal,
    ThroughCorner,
    AlongEdge,
    InFace,
    FromFace,
    FromEdge,
    FromCorner,
    InsideSolid,
    FarOrigin,
    Scaled,
    Rotated,
    ZeroLength,
    Infinite,
    NotANumber,
    kCount
};
constexpr std::array<const char*, size_t(RayClass::kCount)> kClassNames = {
    "AxisParallel", "SignedZero",  "Denormal",  "ThroughCorner", "AlongEdge", "InFace",     "FromFace", "FromEdge",
    "FromCorner",   "InsideSolid", "FarOrigin", "Scaled",        "Rotated",   "ZeroLength", "Infinite", "NotANumber"};

CellRay drawRay(RayClass rayClass, Random& random) {
    const int axis = int(random.below(3)), other = (axis + 1 + int(random.below(2))) % 3;
    const double side = random.below(2) ? 1.0 : -1.0;
    const double small = std::ldexp(1.0 + double(random.unit()), -random.between(0, 1080));
    CellRay ray{drawPoint(random, -6.0, kSize + 6.0), drawDirection(random), draw(random, 0.0, 60.0)};
    switch (rayClass) {
        case RayClass::AxisParallel:
            ray.direction = glm::dvec3(0.0), ray.direction[axis] = side * draw(random, 0.1, 3.0);
            break;
        case RayClass::SignedZero:
            ray.direction[axis] = side * 0.0;
            break;
        case RayClass::Denormal:
            ray.direction[axis] = side * small;
            if (random.below(2)) ray.direction[other] = -side * small * 0.3;
            if (!random.below(4)) ray.direction *= 0x1p-1040, ray.tMax = kInfinity;
            break;
        case RayClass::ThroughCorner: {
            // From a corner to a corner moved back or forth along the line: the planes are crossed at equal t, often exactly.
            const glm::dvec3 corner = drawCorner(random), step = drawCorner(random) - drawCorner(random);
            ray.origin = corner - step * draw(random, 0.0, 1.0);
            ray.direction = step;
            break;
        }
        case RayClass::AlongEdge:
            ray.origin = drawCorner(random), ray.origin[axis] = draw(random, -6.0, kSize + 6.0);
            ray.direction = glm::dvec3(0.0), ray.direction[axis] = side;
            break;
        case RayClass::InFace:
            ray.origin[axis] = random.between(0, kSize), ray.direction[axis] = 0.0;
            break;
        case RayClass::FromFace:
            ray.origin[axis] = random.between(0, kSize);
            break;
        case RayClass::FromEdge:
            ray.origin[axis] = random.between(0, kSize), ray.origin[other] = random.between(0, kSize);
            break;
        case RayClass::FromCorner:
            ray.origin = drawCorner(random);
            break;
        case RayClass::InsideSolid:
            ray.origin = drawPoint(random, 0.0, kSize);
            break;
        case RayClass::FarOrigin: {
            const glm::dvec3 target = drawPoint(random, 0.0, kSize);
            ray.origin = target - ray.direction * std::pow(10.0, draw(random, 2.0, 7.0));
            ray.tMax = 2e7;
            break;
        }
        case RayClass::Scaled: {
            const double scale = std::pow(10.0, draw(random, -4.0, 4.0));
            ray.direction *= scale, ray.tMax /= scale;
            break;
        }
        case RayClass::Rotated:
            break;
        case RayClass::ZeroLength:
            if (random.below(2))
                ray.tMax = 0.0;
            else
                ray.direction = glm::dvec3(0.0);
            break;
        case RayClass::Infinite:
            ray.tMax = kInfinity;
            break;
        case RayClass::NotANumber: {
            const uint32_t place = random.below(7);
            const double value = random.below(3) || place == 6 ? kNaN : side * kInfinity;
            (place < 3 ? ray.origin[int(place)] : place < 6 ? ray.direction[int(place) - 3] : ray.tMax) = value;
            break;
        }
        case RayClass::kCount:
            break;
    }
    return ray;
}

std::string text(const CellRay& ray) {
    std::ostringstream out;
    out << std::hexfloat << "origin " << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << " direction " << ray.direction.x << ' '
        << ray.direction.y << ' ' << ray.direction.z << " tMax " << ray.tMax;
    return out.str();
}

/// tMax may be infinite.
bool isFinite(const CellRay& ray) {
    for (int a = 0; a < 3; ++a)
        if (!std::isfinite(ray.origin[a]) || !std::isfinite(ray.direction[a])) return false;
    return !std::isnan(ray.tMax);
}

void checkRay(const VoxelGrid& grid, const CellRay& ray) {
    const CellHit hit = walkRay(grid, ray);
    const CellHit plain = plainWalk(grid, ray);
    ASSERT_LE(hit.steps, 3 * kSize + 3);
    ASSERT_TRUE(hit.hit == plain.hit && hit.cell == plain.cell && hit.t == plain.t && hit.axis == plain.axis && hit.sign == plain.sign)
        << "a leap changed the walk";
    if (!isFinite(ray)) {
        ASSERT_FALSE(hit.hit) << "a hit from a NaN or an infinity";
        return;
    }
    const Slabs slabs(ray);
    const long double pierced = firstPierced(grid, ray, slabs);
    const long double reach = std::max({std::fabs(ray.origin.x), std::fabs(ray.origin.y), std::fabs(ray.origin.z), 16.0});
    const long double length = std::hypot((long double)ray.direction.x, (long double)ray.direction.y, (long double)ray.direction.z);
    // Half an ulp each of a difference and a quotient, for a place as far away as the origin, and as much again.
    const long double tolerance = length > 0.0L ? reach * 0x1p-51L / length * 4.0L : 0.0L;
    if (!hit.hit) {
        ASSERT_EQ(pierced, HUGE_VALL) << "missed a pierced voxel";
        return;
    }
    ASSERT_TRUE(grid.at(hit.cell));
    if (std::isinf(hit.t)) {  // the hit is real, but its t is beyond any double
        ASSERT_FALSE(slabs.cell(hit.cell).empty());
        ASSERT_LE(slabs.cell(hit.cell).low, pierced);
        return;
    }
    ASSERT_LE(hit.t, pierced + tolerance) << "an earlier voxel was pierced";
    ASSERT_GE(hit.t, 0.0);
    ASSERT_LE(hit.t, ray.tMax);
    // Touched: within the tolerance (in voxels, along each axis) of the closed cell at the reported t.
    for (int a = 0; a < 3; ++a) {
        const long double p = ray.origin[a] + (long double)ray.direction[a] * hit.t;
        ASSERT_GE(p, hit.cell[a] - reach * 0x1p-49L) << "axis " << a;
        ASSERT_LE(p, hit.cell[a] + 1 + reach * 0x1p-49L) << "axis " << a;
    }
    if (hit.axis >= 0) {
        const long double p = ray.origin[hit.axis] + (long double)ray.direction[hit.axis] * hit.t;
        ASSERT_NEAR(double(p - hit.cell[hit.axis]), hit.sign > 0 ? 1.0 : 0.0, double(reach * 0x1p-49L));
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

TEST(RayWalkShell, NothingLeaksThroughOneVoxel) {
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

TEST(RayWalkRules, FacesBelongToTheCellTheRayGoesInto) {
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

TEST(RayWalkRules, EmptySpaceIsLeaptOver) {
    VoxelGrid grid({1024, 64, 64});
    GridWriter(grid).set({1020, 33, 30}, 1);
    const CellHit hit = walkRay(grid, {{-5.0, 33.5, 30.5}, {1, 0, 0}, kInfinity});
    EXPECT_EQ(hit.cell, glm::ivec3(1020, 33, 30));
    EXPECT_EQ(hit.t, 1025.0);
    EXPECT_LE(hit.steps, 31 + 3 + 5);
}

}  // namespace
}  // namespace rubble
