#include <gtest/gtest.h>

#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

using namespace known;

TEST(Stacking, BalancedHolds15AwakeAnd30Asleep) {
    const Tower awake = stack(sleepless(balancedPhysics()), 15, 30.0);
    EXPECT_TRUE(awake.stands());
    EXPECT_LT(awake.lower, 0.02);
    EXPECT_LT(awake.aside, 0.01);
    const Tower asleep = stack(balancedPhysics(), 30, 30.0);
    EXPECT_TRUE(asleep.stands());
    EXPECT_EQ(asleep.awake, 0);
}

TEST(Stacking, AccurateHolds20AwakeAnd60Asleep) {
    EXPECT_LT(stack(sleepless(accuratePhysics()), 20, 15.0).lower, 0.01);
    const Tower asleep = stack(accuratePhysics(), 60, 6.0);
    EXPECT_TRUE(asleep.stands());
    EXPECT_LT(asleep.lower, 0.05);
    EXPECT_EQ(asleep.awake, 0);
}

TEST(Stacking, FastHoldsTwelveAwake) {
    EXPECT_TRUE(stack(sleepless(fastPhysics()), 12, 20.0).stands());
}

TEST(Stacking, HeavyOnLight) {
    EXPECT_LT(sink(fastPhysics(), 100.0), 0.01);
    EXPECT_LT(sink(balancedPhysics(), 100.0), 0.01);
    EXPECT_LT(sink(accuratePhysics(), 1000.0), 0.01);
}

TEST(Stacking, SmallThinAndLongThingsRest) {
    for (const double voxelSize : {0.01, 0.1, 1.0}) {
        EXPECT_LT(unrest({}, voxelSize, {1, 1, 1}), 1e-3) << voxelSize;
        EXPECT_LT(unrest({}, voxelSize, {3, 3, 3}), 1e-3) << voxelSize;
    }
    EXPECT_LT(unrest({}, 0.1, {20, 1, 20}), 1e-3);
    EXPECT_LT(unrest({}, 0.1, {40, 1, 1}), 1e-3);
}

}  // namespace
}  // namespace rubble
