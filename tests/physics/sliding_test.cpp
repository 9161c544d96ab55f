#include <gtest/gtest.h>

#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

using namespace known;

constexpr double kFriction = 0.6;
const double kCritical = glm::degrees(std::atan(kFriction));

TEST(Sliding, AccelerationIsCoulombsOnEveryHeading) {
    const double angle = glm::radians(kCritical + 5.0);
    const double expected = 9.81 * (std::sin(angle) - kFriction * std::cos(angle));
    for (int heading = 0; heading < 12; ++heading)
        EXPECT_NEAR(slideDown({}, kCritical + 5.0, heading * 0.5236 + 0.05, kFriction, 2.0).acceleration, expected,
                    0.01 * expected)
            << heading;
}

TEST(Sliding, SticksATenthOfADegreeBelowAndSlidesAsFarAbove) {
    for (int heading = 0; heading < 12; ++heading) {
        const double turn = heading * 0.5236 + 0.05;
        EXPECT_LT(slideDown({}, kCritical - 0.1, turn, kFriction, 2.0).distance, 1e-4) << heading;
        EXPECT_GT(slideDown({}, kCritical + 0.1, turn, kFriction, 2.0).distance, 5e-3) << heading;
    }
    // Without damping, Coulomb's law gives the distance even this close to the threshold.
    const double angle = glm::radians(kCritical + 0.1);
    const double expected = 9.81 * (std::sin(angle) - kFriction * std::cos(angle)) * 1.5;  // in the second second
    EXPECT_NEAR(slideDown(accuratePhysics(), kCritical + 0.1, 0.05, kFriction, 2.0).distance, expected,
                0.05 * expected);
}

TEST(Sliding, SeamsAreNoBumps) {
    const SeamRide one = rideOverSeams({}, 1000, 1);
    EXPECT_LT(one.lost, 1e-6);
    EXPECT_LT(one.highest, 1e-5);
    EXPECT_LT(one.aside, 1e-5);
    const SeamRide many = rideOverSeams({}, 1000, 52);
    EXPECT_LT(many.lost, 1e-3);
    EXPECT_LT(many.highest, 1e-4);
    EXPECT_LT(many.aside, 1e-3);
}

}  // namespace
}  // namespace rubble
