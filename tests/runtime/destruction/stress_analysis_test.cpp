#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/core/random.h"
#include "tests/runtime/destruction/stress_fixture.h"

namespace rubble {
namespace {

constexpr double kConcreteWeight = 2400.0 * 9.81;  ///< of concrete, N/m3
constexpr double kTensile = 2.6e6, kCompressive = 25e6;

/// The position of a section along its axis, in cells.
int planeOf(const StressCrack& crack) {
    return crack.section.brick[crack.section.axis] * kBrickSize + crack.section.plane;
}

TEST(StressAnalysis, CantileverBreaksAtTheWallAsBeamTheorySays) {
    for (const int depth : {4, 5, 8, 12, 16})
        for (const int offset : {0, 3, 4, 6})
            for (const int length : {8 * depth, 16 * depth}) {
                StressFixture f({280, 40, 40});
                const int wall = offset + 4;
                f.anchor({{offset, 8 + offset, 8 + offset}, {wall, 8 + offset + depth, 8 + offset + depth}});
                f.fill({{wall, 8 + offset, 8 + offset}, {wall + length, 8 + offset + depth, 8 + offset + depth}});
                const double l = length * f.voxelSize, d = depth * f.voxelSize;
                f.strengthScale = kConcreteWeight * 3.0 * l * l / d / kTensile;  // M c / I over the tensile strength
                f.solve();
                const StressCrack& worst = f.analysis.worst();
                EXPECT_NEAR(worst.utilization, 1.0, 0.05) << depth << " " << offset << " " << length;
                EXPECT_EQ(worst.section.axis, 0);
                EXPECT_NEAR(planeOf(worst), wall, 1);
                EXPECT_EQ(worst.cause, FailureMode::Tension);
            }
}

TEST(StressAnalysis, ResultsDoNotDependOnAxisAndVoxelSize) {
    for (const double voxelSize : {0.05, 0.1, 0.25})
        for (int axis = 0; axis < 3; ++axis)
            for (const int loadAxis : {1, 2, 4, 5}) {  // gravity along both of the other axes, in both directions
                StressFixture f({100, 100, 100});
                const int across = (axis + (loadAxis % 3)) % 3;
                const auto box = [&](int from, int to) {
                    CellBox out{glm::ivec3(13), glm::ivec3(19)};
                    out.low[axis] = from, out.high[axis] = to;
                    return out;
                };
                f.voxelSize = voxelSize;
                f.gravity = glm::dvec3(0.0);
                f.gravity[across] = loadAxis < 3 ? -9.81 : 9.81;
                f.anchor(box(8, 12));
                f.fill(box(12, 92));
                const double l = 80 * voxelSize, d = 6 * voxelSize;
                f.strengthScale = kConcreteWeight * 3.0 * l * l / d / kTensile;
                f.solve();
                EXPECT_NEAR(f.analysis.worst().utilization, 1.0, 0.03) << axis << " " << loadAxis;
                EXPECT_EQ(f.analysis.worst().section.axis, axis);
                EXPECT_NEAR(planeOf(f.analysis.worst()), 12, 1);
            }
}

TEST(StressAnalysis, SimplySupportedBeamBreaksInTheMiddle) {
    for (const int depth : {4, 8, 12})
        for (const int offset : {0, 3, 5})
            for (const int length : {12 * depth, 20 * depth}) {
                StressFixture f({280, 40, 40});
                const glm::ivec3 low(8 + offset), high = low + glm::ivec3(length, depth, depth),
                                                  middle = low + depth / 2;
                f.fill({low, high});
                for (const int x : {low.x, high.x - 1}) f.fill({{x, low.y, low.z}, {x + 1, high.y, high.z}}, 3);
                for (const int x : {low.x - 1, high.x})  // a pin: one face of a cell that never breaks
                    f.anchor({{x, middle.y, middle.z}, {x + 1, middle.y + 1, middle.z + 1}}, 3);
                const double l = length * f.voxelSize, d = depth * f.voxelSize;
                f.strengthScale = kConcreteWeight * 0.75 * l * l / d / kTensile;
                f.solve();
                const StressCrack& worst = f.analysis.worst();
                EXPECT_NEAR(worst.utilization, 1.0, 0.05) << depth << " " << offset << " " << length;
                EXPECT_EQ(worst.section.axis, 0);
                EXPECT_NEAR(planeOf(worst), low.x + length / 2, 2);
            }
}

TEST(StressAnalysis, ColumnIsCrushedAtItsFoot) {
    for (const int offset : {0, 3})
        for (const int height : {50, 200}) {
            StressFixture f({40, 240, 40});
            const glm::ivec3 low(8 + offset, offset, 8 + offset);
            f.anchor({low, low + glm::ivec3(8, 1, 8)});
            f.fill({low + glm::ivec3(0, 1, 0), low + glm::ivec3(8, 1 + height, 8)});
            f.strengthScale = kConcreteWeight * height * f.voxelSize / kCompressive;
            f.solve();
            EXPECT_NEAR(f.analysis.worst().utilization, 1.0, 0.01);
            EXPECT_EQ(f.analysis.worst().cause, FailureMode::Compression);
            EXPECT_EQ(planeOf(f.analysis.worst()), low.y + 1);
        }
}

struct PortalStress {
    double middle, beamEnd, columnTop;
    double most() const { return std::max({middle, beamEnd, columnTop}); }
};

/// Tension in a portal frame with clamped feet under its beam's weight (Kleinlogel's formulas), at the faces of the
/// joints.
PortalStress portalStress(double span, double rise, double depth) {
    const double load = kConcreteWeight * depth * depth, modulus = depth * depth * depth / 6.0, area = depth * depth;
    const double corner = load * span * span / (6.0 * (rise / span + 2.0)), thrust = 1.5 * corner / rise;
    const double face = corner - load * span * depth / 4.0 + load * depth * depth / 8.0;
    return {(load * span * span / 8.0 - corner) / modulus - thrust / area, face / modulus - thrust / area,
            (corner - thrust * depth / 2.0) / modulus - load * span / 2.0 / area};
}

TEST(StressAnalysis, PortalFrameBreaksWhereItsMomentIsLargest) {
    for (const int depth : {4, 8})
        for (const int offset : {0, 3})
            for (const int span : {80, 120})
                for (const int rise : {40, 80}) {
                    StressFixture f({160, 120, 40});
                    const int low = 8 + offset, foot = low + 4, width = span + depth, top = foot + rise + depth / 2;
                    for (const int x : {low, low + width - depth}) {
                        f.anchor({{x, low, low}, {x + depth, foot, low + depth}});
                        f.fill({{x, foot, low}, {x + depth, top, low + depth}});
                    }
                    f.fill({{low, top - depth, low}, {low + width, top, low + depth}});
                    const PortalStress stress =
                        portalStress(span * f.voxelSize, rise * f.voxelSize, depth * f.voxelSize);
                    f.strengthScale = stress.most() / kTensile;
                    f.solve();
                    const StressCrack& worst = f.analysis.worst();
                    EXPECT_NEAR(worst.utilization, 1.0, 0.1) << depth << " " << offset << " " << span << " " << rise;
                    const bool isMiddle = worst.section.axis == 0 && std::abs(planeOf(worst) - (low + width / 2)) <= 4;
                    if (stress.middle > 1.15 * std::max(stress.beamEnd, stress.columnTop)) {
                        EXPECT_TRUE(isMiddle) << depth << " " << offset << " " << span << " " << rise;
                    }
                    if (stress.middle < 0.85 * std::max(stress.beamEnd, stress.columnTop)) {
                        EXPECT_FALSE(isMiddle) << depth << " " << offset << " " << span << " " << rise;
                    }
                }
}

TEST(StressAnalysis, NeckUnderAHeavyHeadIsCrushedWhereverItLies) {
    for (const int width : {16, 24})
        for (const int neck : {2, 4, 6})
            for (int offset = 0; offset < 8; ++offset) {
                StressFixture f({48, 72, 48});
                const glm::ivec3 low(8 + offset, offset, 8 + offset),
                    waist = low + glm::ivec3(width / 2 - neck / 2, 16, width / 2 - neck / 2);
                f.anchor({low, low + glm::ivec3(width, 1, width)});
                f.fill({low + glm::ivec3(0, 1, 0), low + glm::ivec3(width, 16, width)});
                f.fill({waist, waist + glm::ivec3(neck, 2, neck)});
                f.fill({low + glm::ivec3(0, 18, 0), low + glm::ivec3(width, 60, width)});
                const double area = double(neck * neck);
                f.strengthScale = kConcreteWeight * f.voxelSize * (42.0 * width * width + area) / area / kCompressive;
                f.solve();
                EXPECT_NEAR(f.analysis.worst().utilization, 1.0, 0.05) << width << " " << neck << " " << offset;
                EXPECT_EQ(f.analysis.worst().section.axis, 1);
                EXPECT_NEAR(planeOf(f.analysis.worst()), low.y + 17, 1);
            }
}

TEST(StressAnalysis, ArchStandsWhereABeamOfItsSpanFalls) {
    for (const int offset : {0, 3}) {
        StressFixture arch({104, 56, 16}), beam({104, 56, 16});
        {
            GridWriter writer(arch.grid);
            for (int z = 0; z < 8; ++z)
                for (int y = 0; y < 48; ++y)
                    for (int x = 0; x < 96; ++x) {
                        const int dx = 2 * x + 1 - 96, dy = 2 * y + 1 - 8, square = dx * dx + dy * dy;
                        if (square >= 64 * 64 && square < 80 * 80) writer.set(glm::ivec3(x, y, z) + offset, 1);
                    }
        }
        arch.anchors.push_back({{0, 0, 0}, {104, 4 + offset, 16}});
        beam.anchor({{offset, 8, 0}, {16 + offset, 16, 8}});
        beam.fill({{16 + offset, 8, 0}, {80 + offset, 16, 8}});
        beam.anchor({{80 + offset, 8, 0}, {96 + offset, 16, 8}});
        arch.strengthScale = beam.strengthScale = 0.04;
        EXPECT_TRUE(arch.solve().empty());
        EXPECT_FALSE(beam.solve().empty());
    }
}

/// What is left of a wall when its free end is removed: nothing can move, and there is nothing to solve.
TEST(StressAnalysis, WhatIsAnchoredAsAWholeConverges) {
    StressFixture f({40, 40, 8});
    f.solve();
    EXPECT_TRUE(f.analysis.hasConverged()) << "nothing at all";
    f.anchor({{0, 0, 0}, {16, 32, 8}});
    f.solve();
    EXPECT_TRUE(f.analysis.hasConverged()) << "only anchored voxels from the start";
    f.fill({{16, 0, 0}, {40, 32, 8}});
    f.strengthScale = 1e-3;
    EXPECT_FALSE(f.solve().empty());
    EXPECT_GT(f.analysis.worst().utilization, 1.0);
    f.fill({{16, 0, 0}, {40, 32, 8}}, 0);
    f.analysis.markChanged(std::vector<glm::ivec3>{{2, 0, 0},
                                                   {3, 0, 0},
                                                   {4, 0, 0},
                                                   {2, 1, 0},
                                                   {3, 1, 0},
                                                   {4, 1, 0},
                                                   {2, 2, 0},
                                                   {3, 2, 0},
                                                   {4, 2, 0},
                                                   {2, 3, 0},
                                                   {3, 3, 0},
                                                   {4, 3, 0}});
    f.solve();
    EXPECT_TRUE(f.analysis.hasConverged()) << "its free part removed";
    EXPECT_EQ(f.analysis.worst().utilization, 0.0);
}

TEST(StressAnalysis, TheSolverConvergesForThinChainsAndBrokenWalls) {
    for (const int thickness : {1, 2, 5})
        for (const int length : {100, 400, 1000}) {
            StressFixture f({length + 8, 16, 16});
            f.anchor({{0, 4, 4}, {4, 4 + thickness, 4 + thickness}});
            f.fill({{4, 4, 4}, {length + 4, 4 + thickness, 4 + thickness}}, 3);
            f.solve();
            EXPECT_TRUE(f.analysis.hasConverged()) << thickness << " voxels, " << length << " long";
        }
    for (uint64_t seed = 1; seed <= 60; ++seed) {
        Random random(seed);
        const glm::ivec3 size(random.between(20, 160), random.between(20, 100), random.between(1, 9));
        StressFixture f(size);
        for (const CellBox& part :
             {CellBox{{0, 0, 0}, {size.x / 2, size.y, size.z}}, CellBox{{size.x / 2, 0, 0}, size}})
            f.fill(part, uint8_t(random.between(1, 3)));
        f.anchor({{0, 0, 0}, {size.x, 2, size.z}});
        for (int hole = 0; hole < 40; ++hole) {
            const glm::ivec3 low(random.between(0, size.x - 1), random.between(2, size.y - 1), 0);
            f.fill({low, glm::min(low + glm::ivec3(random.between(1, 24), random.between(1, 24), size.z), size)}, 0);
        }
        f.solve();
        EXPECT_TRUE(f.analysis.hasConverged()) << "wall of seed " << seed;
    }
}

TEST(StressAnalysis, SlicesOfWorkChangeNothing) {
    StressFixture whole({96, 16, 16}), sliced({96, 16, 16});
    for (StressFixture* f : {&whole, &sliced}) {
        f->anchor({{0, 3, 3}, {4, 13, 13}});
        f->fill({{4, 3, 3}, {90, 13, 13}});
        f->strengthScale = 0.05;
    }
    const std::vector<StressCrack> expected = whole.solve();
    std::vector<glm::ivec3> bricks;
    sliced.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { bricks.push_back(brick); });
    sliced.analysis.markChanged(bricks);
    std::vector<StressCrack> cracks;
    int runs = 0;
    for (; !sliced.analysis.isIdle() && runs < 100'000; ++runs) {
        int64_t work = 500;
        sliced.analysis.run(sliced.shape(), work, 8, cracks);
    }
    EXPECT_GT(runs, 50);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(cracks, expected);
}

}  // namespace
}  // namespace rubble
