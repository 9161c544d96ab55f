#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

TEST(Tunnelling, NothingGoesThroughAWallOfOneVoxel) {
    const bool isLong = std::getenv("RUBBLE_LONG") != nullptr;
    for (const double fastest : {30.0, 300.0}) {
        const known::Shots shots = known::shoot({}, isLong ? 50000 : 5000, 1, fastest);
        EXPECT_EQ(shots.through, 0) << "of " << shots.fired << " up to " << fastest << " m/s";
    }
}

/// What another knocks into the wall within the step meets it. A few in 10,000 get a corner through and follow it: not mended.
TEST(Tunnelling, TwoThatMeetAtTheWallDoNotKnockEachOtherThrough) {
    const bool isLong = std::getenv("RUBBLE_LONG") != nullptr;
    for (const double late : {0.0, 0.002, 0.01}) {
        const known::Shots shots = known::shootPairs({}, isLong ? 10000 : 700, 1, 300.0, late);
        EXPECT_LE(shots.through, shots.fired / 1000) << "of " << shots.fired << " up to " << late << " s late";
    }
}

}  // namespace
}  // namespace rubble
