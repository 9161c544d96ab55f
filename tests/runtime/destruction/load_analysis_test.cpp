#include <gtest/gtest.h>

#include "tests/runtime/destruction/load_beams.h"

namespace rubble {
namespace {

/// Where a section is, along its axis.
int planeOf(const LoadCrack& crack) {
    return crack.section.brick[crack.section.axis] * kBrickSize + crack.section.plane;
}

TEST(LoadAnalysis, CantileverBreaksAtTheWallAsBeamTheorySays) {
    for (const int depth : {4, 5, 8, 12, 16})
        for (const int offset : {0, 3, 4, 6})
            for (const int length : {8 * depth, 16 * depth}) {
                LoadFixture f({280, 40, 40});
                const int wall = offset + 4;
                f.anchor({{offset, 8 + offset, 8 + offset}, {wall, 8 + offset + depth, 8 + offset + depth}});
                f.fill({{wall, 8 + offset, 8 + offset}, {wall + length, 8 + offset + depth, 8 + offset + depth}});
                f.solve();
                const double l = length * f.voxelSize, d = depth * f.voxelSize;
                const double expected = 2400.0 * 9.81 * 3.0 * l * l / d / 2.6e6;  // M c / I over the tensile strength
                const LoadCrack& worst = f.analysis.worst();
                EXPECT_NEAR(worst.share / expected, 1.0, 0.07) << depth << " " << offset << " " << length;
                EXPECT_EQ(worst.section.axis, 0);
                EXPECT_NEAR(planeOf(worst), wall, 1);
                EXPECT_EQ(worst.cause, LoadFailure::Tension);
            }
}

}  // namespace
}  // namespace rubble
