#include <gtest/gtest.h>

#include "tests/physics/scenes/seam_scenes.h"

// What slides over a gap that is narrower than half of it keeps its support: it neither hops nor loses speed. A crate
// lies in its floor by a fifth of a millimetre. When a step begins while its front has just passed the gap, it overlaps
// the edge beyond by less along its way than across, which must not make that edge a wall.

namespace rubble {
namespace {

using namespace known;

/// Expects no hop for phases of the step around the edge beyond the gap.
void expectNoTrip(GapSlide slide) {
    for (const double beyond : {-0.0002, 0.00003, 0.0001, 0.00025, 0.001, 0.004, 0.007}) {
        slide.beyond = beyond;
        const GapRide ride = rideOverGap(slide);
        const auto of = testing::Message()
                        << "tiles " << int(slide.tiles) << " of " << slide.voxel << " m, gap " << slide.gap << ", "
                        << slide.speed << " m/s, yaw " << slide.yaw << ", " << beyond << " m beyond";
        EXPECT_LT(ride.highest, 0.001) << of;
        EXPECT_NEAR(ride.lost, 0.0, 0.01) << of;
        EXPECT_LT(ride.tilted, 0.01) << of;
    }
}

TEST(Gaps, ACrateSlidesOverGapsNarrowerThanHalfOfIt) {
    for (const double gap : {0.01, 0.05, 0.07, 0.13, 0.18})
        for (const double speed : {0.2, 0.5, 1.0, 2.0, 3.0, 6.0, 14.0, 20.0})
            expectNoTrip({.gap = gap, .speed = speed});
}

TEST(Gaps, SizeOfVoxelsAndHeadingMakeNoDifference) {
    for (const Tiles tiles : {Tiles::Shapes, Tiles::Bodies})
        for (const double voxel : {0.05, 0.1, 0.2})
            for (const double yaw : {0.0, 0.3, 0.7854})
                for (const double speed : {1.0, 6.0}) expectNoTrip({tiles, voxel, 0.07, speed, 0.0, yaw});
}

TEST(Gaps, BetweenBodiesThatMayMoveTheyDoNotTrip) {
    for (const double gap : {0.02, 0.07, 0.15})
        for (const double yaw : {0.0, 0.3})
            for (const double speed : {0.5, 2.0, 6.0, 14.0})
                expectNoTrip({Tiles::DynamicShapes, 0.1, gap, speed, 0.0, yaw});
}

}  // namespace
}  // namespace rubble
