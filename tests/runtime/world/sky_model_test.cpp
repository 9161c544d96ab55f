#include "runtime/world/level/sky_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace rubble {
namespace {

Environment under(double degrees, float clouds = 0.4f) {
    Environment air;
    air.clouds = clouds;
    const double angle = degrees * 0.01745329252;
    applySkyModel(air, {-float(std::cos(angle)), float(std::sin(angle)), 0.0f});
    return air;
}

float brightness(glm::vec3 color) {
    return glm::dot(color, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

TEST(SkyModel, AnAfternoonMatchesTheScenes) {
    const Environment air = under(21.8);
    const auto near = [](glm::vec3 found, glm::vec3 expected) {
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 0.2f * expected[i]);
    };
    near(air.sunColor, {11.5f, 8.7f, 5.7f});
    near(air.skyColor, {0.24f, 0.42f, 0.80f});
    near(air.horizonColor, {0.74f, 0.64f, 0.52f});
}

TEST(SkyModel, ALowSunIsRedderAndDimmer) {
    Environment higher = under(80.0);
    for (const double degrees : {50.0, 25.0, 12.0, 6.0, 3.0, 1.0}) {
        const Environment air = under(degrees);
        EXPECT_LT(brightness(air.sunColor), brightness(higher.sunColor)) << degrees;
        EXPECT_GT(air.sunColor.r / air.sunColor.b, higher.sunColor.r / higher.sunColor.b) << degrees;
        EXPECT_LE(brightness(air.skyColor), 1.25f * brightness(higher.skyColor)) << degrees;
        EXPECT_EQ(air.stars, 0.0f);
        higher = air;
    }
}

TEST(SkyModel, SunsetIsContinuous) {
    Environment before = under(10.0);
    for (double degrees = 9.9; degrees > -2.5; degrees -= 0.1) {
        const Environment air = under(degrees);
        EXPECT_LT(glm::length(air.skyColor - before.skyColor), 0.03f) << degrees;
        EXPECT_LT(glm::length(air.horizonColor - before.horizonColor), 0.03f) << degrees;
        EXPECT_LT(glm::length(air.sunColor - before.sunColor), 0.6f) << degrees;
        before = air;
    }
    // Sunlight fades to nothing before moonlight replaces it.
    EXPECT_LT(glm::length(under(-2.8).sunColor), 1e-3f);
    EXPECT_LT(glm::length(under(-2.9).sunColor), 1e-3f);
}

TEST(SkyModel, NightHasAMoonAndStarsBehindItsClouds) {
    const Environment air = under(-25.0);
    EXPECT_GT(air.sunDirection.y, 0.2f);
    EXPECT_GT(air.sunColor.b, air.sunColor.r);
    EXPECT_LT(brightness(air.skyColor), 0.02f * brightness(under(40.0).skyColor) + 0.02f);
    EXPECT_GT(air.stars, 0.9f);
    EXPECT_EQ(under(-25.0, 1.0f).stars, 0.0f);
}

TEST(SkyModel, CloudsHideTheSunAndGreyTheSky) {
    const Environment clear = under(25.0), covered = under(25.0, 1.0f);
    EXPECT_LT(brightness(covered.sunColor), 0.01f * brightness(clear.sunColor));
    EXPECT_LT(covered.skyColor.b / covered.skyColor.r, 1.3f);
    EXPECT_GT(clear.skyColor.b / clear.skyColor.r, 2.0f);
    EXPECT_GT(brightness(covered.skyColor), 0.3f);
}

}  // namespace
}  // namespace rubble
