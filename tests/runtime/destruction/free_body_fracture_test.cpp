#include "runtime/destruction/free_body_fracture.h"

#include <gtest/gtest.h>

#include "tests/runtime/destruction/stress_fixture.h"

namespace rubble {
namespace {

constexpr double kTensileStrength = 2.6e6;

/// A concrete beam along an axis, and the force across it that has the bending moment force * length / divisor.
struct Beam {
    int axis, length, depth, offset;
    StressFixture fixture{glm::ivec3(140)};

    Beam(int along, int cells, int cellsDeep, int first = 3)
        : axis(along), length(cells), depth(cellsDeep), offset(first) {
        CellBox box{glm::ivec3(offset), glm::ivec3(offset + depth)};
        box.high[axis] = offset + length;
        fixture.fill(box);
        fixture.gravity = glm::dvec3(0.0);
    }
    double force(double divisor) const {
        const double d = depth * fixture.voxelSize, l = length * fixture.voxelSize;
        return kTensileStrength * d * d * d / 6.0 / l * divisor;
    }
    std::vector<FracturePlane> hit(int at, double newtons, uint32_t seed = 1) const {
        ImpactForce impact{glm::ivec3(offset + depth / 2), glm::dvec3(0.0)};
        impact.cell[axis] = offset + at;
        impact.force[(axis + 1) % 3] = newtons;
        return findFracturePlanes(fixture.shape(), impact, seed);
    }
    std::vector<FracturePlane> hitAtEnd(double utilization) const { return hit(0, utilization * force(27.0 / 4.0)); }
};

TEST(FreeBodyFracture, AFreeBeamHitAtItsEndBreaksAThirdAway) {
    for (int axis = 0; axis < 3; ++axis)
        for (const int depth : {4, 8}) {
            const Beam beam(axis, 120, depth);
            EXPECT_TRUE(beam.hitAtEnd(0.95).empty());  // F L 4 / 27, at L / 3
            const std::vector<FracturePlane> planes = beam.hitAtEnd(1.05);
            ASSERT_EQ(planes.size(), 1u);
            EXPECT_EQ(planes[0].axis, axis);
            EXPECT_NEAR(planes[0].plane, beam.offset + 40, 6);
            EXPECT_EQ(planes[0].cause, FailureMode::Tension);
        }
}

TEST(FreeBodyFracture, AFreeBeamHitInItsMiddleBreaksThere) {
    const Beam beam(1, 120, 8);
    EXPECT_TRUE(beam.hit(60, 0.95 * beam.force(8.0)).empty());
    const std::vector<FracturePlane> planes = beam.hit(60, 1.05 * beam.force(8.0));
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(planes[0].plane, beam.offset + 60, 2);
}

TEST(FreeBodyFracture, ThePartsWithstandTheImpact) {
    const Beam beam(2, 120, 8);
    for (const auto& [utilization, parts] : {std::pair{1.5, 2u}, {4.5, 3u}, {9.5, 4u}}) {
        const std::vector<FracturePlane> planes = beam.hit(60, utilization * beam.force(8.0));
        EXPECT_EQ(planes.size() + 1, parts) << utilization;
        for (size_t i = 1; i < planes.size(); ++i) EXPECT_GE(planes[i].plane - planes[i - 1].plane, 6);
    }
    const auto placesOf = [&](uint32_t seed) {
        std::vector<int> out;
        for (const FracturePlane& plane : beam.hit(60, 9.5 * beam.force(8.0), seed)) out.push_back(plane.plane);
        return out;
    };
    EXPECT_EQ(placesOf(7), placesOf(7));
    EXPECT_NE(placesOf(7), placesOf(8));
}

TEST(FreeBodyFracture, ANeckBreaksFirst) {
    Beam beam(0, 120, 8);
    beam.fixture.fill({{70, 3, 3}, {72, 11, 11}}, 0);
    beam.fixture.fill({{70, 5, 5}, {72, 9, 9}});
    const std::vector<FracturePlane> planes = beam.hit(20, 0.5 * beam.force(27.0 / 4.0));
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(planes[0].plane, 71, 1);
}

TEST(FreeBodyFracture, ShortAndUnbreakableBodiesStayWhole) {
    const Beam cube(0, 8, 8);
    EXPECT_TRUE(cube.hit(4, 1e12).empty());
    Beam weak(0, 120, 8);
    weak.fixture.entries[1].tensile = weak.fixture.entries[1].compressive = weak.fixture.entries[1].shear = 0.0;
    EXPECT_FALSE(weak.hit(60, 1.0).empty()) << "a strength of zero must not give a NaN";
    Beam steel(0, 120, 8);
    steel.fixture.fill({{3, 3, 3}, {123, 11, 11}}, 3);
    EXPECT_TRUE(steel.hit(60, 1e12).empty());
}

}  // namespace
}  // namespace rubble
