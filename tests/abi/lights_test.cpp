#include <limits>

#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

class AbiLights : public Abi {
protected:
    rubble_environment environment() const {
        auto out = sized<rubble_environment>();
        EXPECT_EQ(api()->environment(m_world, &out), RUBBLE_OK) << api()->last_error();
        return out;
    }
    rubble_light_state lamp() const {
        rubble_light light = 0;
        uint32_t count = 0;
        EXPECT_EQ(api()->lights(m_world, &light, 1, &count), RUBBLE_OK) << api()->last_error();
        EXPECT_EQ(count, 1u);
        auto out = sized<rubble_light_state>();
        EXPECT_EQ(api()->light_state(m_world, light, &out), RUBBLE_OK) << api()->last_error();
        return out;
    }
};

TEST_F(AbiLights, TheWeatherChangesWithTheNextStep) {
    rubble_environment now = environment();
    EXPECT_DOUBLE_EQ(now.gravity[1], double(-9.81f));
    now.wetness = 1.0;
    now.gravity[1] = -1.6;
    now.sun_direction[0] = 0.0, now.sun_direction[1] = 2.0, now.sun_direction[2] = 0.0;
    ASSERT_EQ(api()->set_environment(m_world, &now), RUBBLE_OK) << api()->last_error();
    EXPECT_EQ(environment().wetness, 0.0) << "edits wait for the step";
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(environment().wetness, 1.0);
    EXPECT_EQ(environment().sun_direction[1], 1.0) << "it is made a direction";
    EXPECT_EQ(environment().gravity[1], double(-1.6f));
}

TEST_F(AbiLights, TheSkyFollowsTheSun) {
    rubble_environment day = environment(), night = day;
    const double up[3] = {0.2, 1.0, 0.1}, down[3] = {0.2, -1.0, 0.1}, none[3] = {};
    ASSERT_EQ(api()->follow_sun(&day, up), RUBBLE_OK) << api()->last_error();
    ASSERT_EQ(api()->follow_sun(&night, down), RUBBLE_OK) << api()->last_error();
    EXPECT_EQ(day.stars, 0.0);
    EXPECT_GT(night.stars, 0.0);
    EXPECT_GT(day.sky_color[2], 5.0 * night.sky_color[2]);
    EXPECT_EQ(day.struct_size, sizeof day);
    expectRefused(api()->follow_sun(&day, none), RUBBLE_ERROR_ARGUMENT, "to_sun");
    EXPECT_EQ(api()->follow_sun(&day, nullptr), RUBBLE_ERROR_NULL);
}

TEST_F(AbiLights, ALampIsDimmedMovedAndPutOut) {
    rubble_light_state now = lamp();
    EXPECT_EQ(now.kind, uint32_t(RUBBLE_LIGHT_SPHERE));
    EXPECT_EQ(now.flags, uint32_t(RUBBLE_LIGHT_ENABLED));
    EXPECT_DOUBLE_EQ(now.color[1], 4.0);
    now.color[1] = 0.5;
    now.position[1] = 2.0;
    now.flags = 0;
    ASSERT_EQ(api()->set_light(m_world, &now), RUBBLE_OK) << api()->last_error();
    EXPECT_DOUBLE_EQ(lamp().color[1], 4.0) << "edits wait for the step";
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_DOUBLE_EQ(lamp().color[1], 0.5);
    EXPECT_DOUBLE_EQ(lamp().position[1], 2.0);
    EXPECT_EQ(lamp().flags, 0u);
}

TEST_F(AbiLights, WhatCannotShineIsRefused) {
    rubble_light_state light = lamp();
    light.color[2] = -1.0;
    expectRefused(api()->set_light(m_world, &light), RUBBLE_ERROR_ARGUMENT, "color[2]");
    light = lamp();
    light.flags = 64;
    expectRefused(api()->set_light(m_world, &light), RUBBLE_ERROR_ARGUMENT, "flags");
    light = lamp();
    light.light = 0;
    expectRefused(api()->set_light(m_world, &light), RUBBLE_ERROR_STALE, "light is 0");
    rubble_environment sky = environment();
    sky.exposure = std::numeric_limits<double>::quiet_NaN();
    expectRefused(api()->set_environment(m_world, &sky), RUBBLE_ERROR_ARGUMENT, "exposure");
    sky = environment();
    for (double& axis : sky.sun_direction) axis = 0.0;
    expectRefused(api()->set_environment(m_world, &sky), RUBBLE_ERROR_ARGUMENT, "sun_direction");
}

}  // namespace
}  // namespace rubble
