#include <limits>

#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

class AbiLights : public Abi {
protected:
    rubble_environment environment() const {
        auto out = sized<rubble_environment>();
        EXPECT_EQ(api()->get_environment(m_world, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    using List = rubble_result (*)(rubble_world, rubble_light*, uint32_t, uint32_t*);
    std::vector<rubble_light> listed(List list) const {
        uint32_t count = 0;
        EXPECT_EQ(list(m_world, nullptr, 0, &count), RUBBLE_OK) << api()->get_last_error();
        std::vector<rubble_light> out(count);
        EXPECT_EQ(list(m_world, out.data(), count, &count), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    rubble_light_settings settingsOf(rubble_light light) const {
        auto out = sized<rubble_light_settings>();
        EXPECT_EQ(api()->get_light_settings(m_world, light, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    rubble_light_settings levelLight() const {
        const std::vector<rubble_light> lights = listed(api()->get_lights);
        EXPECT_EQ(lights.size(), 1u);
        return settingsOf(lights.at(0));
    }
    rubble_shape table() const {
        rubble_shape_state shape = {};
        uint32_t count = 0;
        EXPECT_EQ(api()->get_shape_states(m_world, 0, &shape, 1, &count), RUBBLE_OK) << api()->get_last_error();
        return shape.shape;
    }
    static rubble_light_settings torch() {
        auto out = sized<rubble_light_settings>();
        out.flags = RUBBLE_LIGHT_ENABLED;
        out.position[0] = 0.85, out.position[1] = 1.5, out.position[2] = 0.85;
        out.color[0] = 9.0, out.color[1] = 5.0, out.color[2] = 2.0;
        out.radius = 0.05, out.reach = 10.0;
        return out;
    }
};

TEST_F(AbiLights, TheWeatherChangesWithTheNextStep) {
    rubble_environment now = environment();
    EXPECT_DOUBLE_EQ(now.gravity[1], double(-9.81f));
    now.wetness = 1.0;
    now.gravity[1] = -1.6;
    now.sun_direction[0] = 0.0, now.sun_direction[1] = 2.0, now.sun_direction[2] = 0.0;
    ASSERT_EQ(api()->set_environment(m_world, &now), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(environment().wetness, 0.0) << "edits wait for the step";
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(environment().wetness, 1.0);
    EXPECT_EQ(environment().sun_direction[1], 1.0) << "directions are normalised";
    EXPECT_EQ(environment().gravity[1], double(-1.6f));
}

TEST_F(AbiLights, TheSkyFollowsTheSun) {
    rubble_environment day = environment(), night = day;
    const double up[3] = {0.2, 1.0, 0.1}, down[3] = {0.2, -1.0, 0.1}, none[3] = {};
    ASSERT_EQ(api()->apply_sky_model(&day, up), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->apply_sky_model(&night, down), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(day.stars, 0.0);
    EXPECT_GT(night.stars, 0.0);
    EXPECT_GT(day.sky_color[2], 5.0 * night.sky_color[2]);
    EXPECT_EQ(day.struct_size, sizeof day);
    expectRefused(api()->apply_sky_model(&day, none), RUBBLE_ERROR_ARGUMENT, "sun_direction");
    EXPECT_EQ(api()->apply_sky_model(&day, nullptr), RUBBLE_ERROR_NULL);
}

TEST_F(AbiLights, ALightIsDimmedMovedAndTurnedOff) {
    rubble_light_settings now = levelLight();
    EXPECT_EQ(now.kind, uint32_t(RUBBLE_LIGHT_SPHERE));
    EXPECT_EQ(now.flags, uint32_t(RUBBLE_LIGHT_ENABLED));
    EXPECT_DOUBLE_EQ(now.color[1], 4.0);
    now.color[1] = 0.5;
    now.position[1] = 2.0;
    now.flags = 0;
    ASSERT_EQ(api()->set_light(m_world, &now), RUBBLE_OK) << api()->get_last_error();
    EXPECT_DOUBLE_EQ(levelLight().color[1], 4.0) << "edits wait for the step";
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_DOUBLE_EQ(levelLight().color[1], 0.5);
    EXPECT_DOUBLE_EQ(levelLight().position[1], 2.0);
    EXPECT_EQ(levelLight().flags, 0u);
}

TEST_F(AbiLights, ALightIsAddedMovedAndRemoved) {
    rubble_light_settings first = torch(), second = torch();
    second.kind = RUBBLE_LIGHT_CONE;
    second.flags = RUBBLE_LIGHT_ENABLED | RUBBLE_LIGHT_TWO_SIDED;
    second.shape = table();
    second.rotation[0] = 1.0;
    second.cone_inner = 0.25, second.cone_outer = 0.5, second.width = 1.5, second.height = 2.5;
    ASSERT_EQ(api()->add_light(m_world, &first), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->add_light(m_world, &second), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(listed(api()->get_lights).size(), 1u) << "edits wait for the step";
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(listed(api()->get_lights).size(), 3u);
    const std::vector<rubble_light> added = listed(api()->get_added_lights);
    ASSERT_EQ(added.size(), 2u);
    rubble_light one = 0;
    uint32_t count = 0;
    expectRefused(api()->get_added_lights(m_world, &one, 1, &count), RUBBLE_ERROR_CAPACITY, "2 rows");

    const rubble_light_settings now = settingsOf(added[1]);
    EXPECT_EQ(now.kind, second.kind);
    EXPECT_EQ(now.flags, second.flags);
    EXPECT_EQ(now.shape, second.shape);
    EXPECT_EQ(now.group, 0u);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(now.rotation[i], second.rotation[i]);
    EXPECT_EQ(now.width, 1.5);
    EXPECT_EQ(now.height, 2.5);
    rubble_light_settings carried = settingsOf(added[0]);
    EXPECT_EQ(carried.position[1], 1.5);
    carried.position[1] = 2.0;
    carried.shape = table();
    ASSERT_EQ(api()->set_light(m_world, &carried), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_TRUE(listed(api()->get_added_lights).empty()) << "the last step added none";
    EXPECT_EQ(settingsOf(added[0]).position[1], 2.0);
    EXPECT_EQ(settingsOf(added[0]).shape, table());

    ASSERT_EQ(api()->remove_light(m_world, added[0]), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->remove_light(m_world, added[0]), RUBBLE_OK) << "edits wait for the step";
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(listed(api()->get_lights).size(), 2u);
    expectRefused(api()->remove_light(m_world, added[0]), RUBBLE_ERROR_STALE, "light is stale");
    expectRefused(api()->set_light(m_world, &carried), RUBBLE_ERROR_STALE, "light is stale");
    expectRefused(api()->get_light_settings(m_world, added[0], &carried), RUBBLE_ERROR_STALE, "light is stale");
}

TEST_F(AbiLights, ALightOfADestroyedShapeIsTurnedOff) {
    rubble_light_settings riding = torch();
    riding.shape = table();
    auto all = sized<rubble_carve>();
    all.position[0] = all.position[1] = all.position[2] = 0.85;
    for (double& radius : all.radii) radius = 5.0;
    ASSERT_EQ(api()->carve(m_world, &all), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->add_light(m_world, &riding), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    const rubble_light_settings left = settingsOf(listed(api()->get_added_lights).at(0));
    EXPECT_EQ(left.shape, 0u);
    EXPECT_EQ(left.flags, 0u);
    EXPECT_NEAR(left.position[1], 1.5, 1e-9);
    expectRefused(api()->add_light(m_world, &riding), RUBBLE_ERROR_STALE, "shape is stale");
    rubble_light_settings moved = left;
    moved.shape = riding.shape;
    expectRefused(api()->set_light(m_world, &moved), RUBBLE_ERROR_STALE, "shape is stale");
}

TEST_F(AbiLights, UndoRestoresLightsAndWeather) {
    ASSERT_EQ(api()->set_undo_limit(m_world, 4), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    const rubble_environment dry = environment();
    rubble_environment rain = dry;
    rain.wetness = 1.0;
    rubble_light_settings dim = levelLight();
    dim.color[1] = 0.5;
    const rubble_light_settings another = torch();
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->set_environment(m_world, &rain), RUBBLE_OK);
    ASSERT_EQ(api()->set_light(m_world, &dim), RUBBLE_OK);
    ASSERT_EQ(api()->add_light(m_world, &another), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(environment().wetness, 1.0);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(environment().wetness, dry.wetness);
    EXPECT_EQ(levelLight().color[1], 4.0) << "the old light has its old colour";
    ASSERT_EQ(api()->redo(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(environment().wetness, 1.0);
    EXPECT_EQ(listed(api()->get_lights).size(), 2u);
}

TEST_F(AbiLights, InvalidLightsAreRefused) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), huge = std::numeric_limits<double>::max();
    const auto expectBad = [&](void (*spoil)(rubble_light_settings&, double), double with, rubble_result code,
                               const char* word) {
        rubble_light_settings added = torch(), set = levelLight();
        spoil(added, with), spoil(set, with);
        expectRefused(api()->add_light(m_world, &added), code, word);
        expectRefused(api()->set_light(m_world, &set), code, word);
    };
    expectBad([](rubble_light_settings& l, double x) { l.color[2] = x; }, -1.0, RUBBLE_ERROR_ARGUMENT,
              "color[2] is -1, expected 0 to 1e+06");
    for (const double bad : {nan, huge, -huge, -1.0}) {
        expectBad([](rubble_light_settings& l, double x) { l.color[0] = x; }, bad, RUBBLE_ERROR_ARGUMENT, "color[0]");
        expectBad([](rubble_light_settings& l, double x) { l.radius = x; }, bad, RUBBLE_ERROR_ARGUMENT, "radius");
        expectBad([](rubble_light_settings& l, double x) { l.reach = x; }, bad, RUBBLE_ERROR_ARGUMENT, "reach");
        expectBad([](rubble_light_settings& l, double x) { l.cone_inner = x; }, bad, RUBBLE_ERROR_ARGUMENT,
                  "cone_inner");
        expectBad([](rubble_light_settings& l, double x) { l.cone_outer = x; }, bad, RUBBLE_ERROR_ARGUMENT,
                  "cone_outer");
        expectBad([](rubble_light_settings& l, double x) { l.width = x; }, bad, RUBBLE_ERROR_ARGUMENT, "width");
        expectBad([](rubble_light_settings& l, double x) { l.height = x; }, bad, RUBBLE_ERROR_ARGUMENT, "height");
        expectBad([](rubble_light_settings& l, double x) { l.rotation[1] = x * 2.0; }, bad, RUBBLE_ERROR_ARGUMENT,
                  "rotation");
    }
    for (const double bad : {nan, huge, -huge})
        expectBad([](rubble_light_settings& l, double x) { l.position[1] = x; }, bad, RUBBLE_ERROR_ARGUMENT,
                  "position[1]");
    expectBad([](rubble_light_settings& l, double) { l.flags = 64; }, 0.0, RUBBLE_ERROR_ARGUMENT, "flags");
    expectBad([](rubble_light_settings& l, double) { l.kind = 5; }, 0.0, RUBBLE_ERROR_ARGUMENT,
              "kind is 5, expected 0 to 4");
    expectBad([](rubble_light_settings& l, double) { l.kind = 256; }, 0.0, RUBBLE_ERROR_ARGUMENT, "kind");
    expectBad([](rubble_light_settings& l, double) { l.shape = ~0ull; }, 0.0, RUBBLE_ERROR_STALE,
              "shape is a handle of another type");
    expectBad([](rubble_light_settings& l, double) { l.group = l.light ? l.light : 1; }, 0.0, RUBBLE_ERROR_STALE,
              "group");
    expectBad([](rubble_light_settings& l, double) { l.struct_size = 8; }, 0.0, RUBBLE_ERROR_STRUCT_SIZE,
              "struct_size");
    rubble_light_settings stale = torch();
    stale.shape = table() + 1;
    expectRefused(api()->add_light(m_world, &stale), RUBBLE_ERROR_STALE, "shape is stale");
    expectRefused(api()->add_light(m_world, nullptr), RUBBLE_ERROR_NULL, "add_light");
    expectRefused(api()->remove_light(m_world, 0), RUBBLE_ERROR_STALE, "light is 0");
    expectRefused(api()->remove_light(m_world, table()), RUBBLE_ERROR_STALE, "another type");
    expectRefused(api()->remove_light(0, levelLight().light), RUBBLE_ERROR_STALE, "world");
    expectRefused(api()->get_added_lights(m_world, nullptr, 0, nullptr), RUBBLE_ERROR_NULL, "count");
    rubble_light_settings none = levelLight();
    none.light = 0;
    expectRefused(api()->set_light(m_world, &none), RUBBLE_ERROR_STALE, "light is 0");
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_EQ(listed(api()->get_lights).size(), 1u) << "a refused call changes nothing";
    EXPECT_DOUBLE_EQ(levelLight().color[1], 4.0);
}

TEST_F(AbiLights, BothEndsOfARangeAreAllowed) {
    rubble_light_settings light = torch();
    light.cone_inner = light.cone_outer = 3.15;  // as a float it is a little more
    EXPECT_EQ(api()->add_light(m_world, &light), RUBBLE_OK) << api()->get_last_error();
    light.cone_outer = 3.1501;
    expectRefused(api()->add_light(m_world, &light), RUBBLE_ERROR_ARGUMENT, "cone_outer is 3.1501, expected 0 to 3.15");
}

TEST_F(AbiLights, InvalidWeatherIsRefused) {
    rubble_environment sky = environment();
    sky.exposure = std::numeric_limits<double>::quiet_NaN();
    expectRefused(api()->set_environment(m_world, &sky), RUBBLE_ERROR_ARGUMENT, "exposure is nan, expected 0 to 1e+06");
    sky = environment();
    sky.fog_base = 1e300;
    expectRefused(api()->set_environment(m_world, &sky), RUBBLE_ERROR_ARGUMENT, "fog_base");
    sky = environment();
    for (double& axis : sky.sun_direction) axis = 0.0;
    expectRefused(api()->set_environment(m_world, &sky), RUBBLE_ERROR_ARGUMENT, "sun_direction");
}

}  // namespace
}  // namespace rubble
