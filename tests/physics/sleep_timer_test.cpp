#include "physics/bodies/sleep_timer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace rubble {
namespace {

constexpr RestLimits kLimits{.time = 0.5, .velocity = 4e-3, .acceleration = 1e-3, .stepSeconds = 1.0 / 60.0};

/// How many steps of some seconds a body rests in whose position along x is x(t), metres.
int restingSteps(const std::function<double(double)>& x, double seconds) {
    SleepTimer timer;
    timer.restart({{x(0.0), 0.0, 0.0}});
    int resting = 0;
    for (int i = 1; i <= int(60.0 * seconds); ++i) resting += timer.rests({{x(i / 60.0), 0.0, 0.0}}, 1.0, kLimits);
    return resting;
}

TEST(SleepTimer, WhatStandsOrOnlyShakesRests) {
    EXPECT_GT(restingSteps([](double) { return 1.0; }, 4.0), 200);
    EXPECT_GT(restingSteps([](double t) { return 1e-6 * std::sin(90.0 * t); }, 4.0), 200);
}

/// As a pillar of 30 m does: slower than what may rest at first, but 0.1 m away after ten seconds, and 7 m after 16.
TEST(SleepTimer, WhatFallsFromAnUnstableBalanceNeverRests) {
    for (const double rate : {0.6, 0.7, 1.0})
        EXPECT_EQ(restingSteps([&](double t) { return 1e-4 * std::exp(rate * t); }, 8.0), 0) << rate;
}

}  // namespace
}  // namespace rubble
