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

}  // namespace
}  // namespace rubble
