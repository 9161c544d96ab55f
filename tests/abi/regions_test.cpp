#include <array>
#include <vector>

#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

TEST_F(Abi, QueriesAreBatched) {
    const std::array<rubble_ray, 3> rays = {rubble_ray{{0.85, 5.0, 0.85}, {0.0, -1.0, 0.0}, 10.0, 0.0},
                                            rubble_ray{{0.85, 5.0, 0.85}, {0.0, -1.0, 0.0}, 10.0, 0.2},
                                            rubble_ray{{5.0, 5.0, 5.0}, {0.0, -1.0, 0.0}, 10.0, 0.0}};
    std::array<rubble_hit, 3> hits = {};
    ASSERT_EQ(api()->cast_rays(m_world, rays.data(), 3, nullptr, hits.data()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hits[0].hit, 1u);
    EXPECT_NEAR(hits[0].distance, 4.0, 1e-6);  // a voxel is 0.1f metres
    EXPECT_NEAR(hits[1].distance, 3.8, 1e-6);
    EXPECT_EQ(hits[2].hit, 0u);
    auto filter = sized<rubble_query_filter>();
    filter.rejected_shape_count = 1;
    filter.rejected_shapes = &hits[0].shape;
    rubble_hit none = {};
    ASSERT_EQ(api()->cast_rays(m_world, rays.data(), 1, &filter, &none), RUBBLE_OK);
    EXPECT_EQ(none.hit, 0u);

    rubble_shape_cast cast = {};
    cast.shape.kind = RUBBLE_QUERY_BOX;
    cast.shape.position[0] = cast.shape.position[2] = 0.85, cast.shape.position[1] = 3.0;
    cast.shape.half_size[0] = cast.shape.half_size[1] = cast.shape.half_size[2] = 0.5;
    cast.direction[1] = -1.0;
    cast.max_distance = 10.0;
    ASSERT_EQ(api()->cast_shapes(m_world, &cast, 1, nullptr, &none), RUBBLE_OK) << api()->get_last_error();
    EXPECT_NEAR(none.distance, 1.5, 1e-6);
    uint32_t count = 0;
    uint64_t found = 0;
    cast.shape.position[1] = 1.2;
    ASSERT_EQ(api()->overlap_bodies(m_world, &cast.shape, nullptr, &found, 1, &count), RUBBLE_OK);
    EXPECT_EQ(count, 1u);
    EXPECT_EQ(found, hits[0].body);
    ASSERT_EQ(api()->overlap_shapes(m_world, &cast.shape, &filter, &found, 1, &count), RUBBLE_OK);
    EXPECT_EQ(count, 0u);
    const double above[3] = {0.85, 1.5, 0.85};
    ASSERT_EQ(api()->find_closest_point(m_world, above, 10.0, nullptr, &none), RUBBLE_OK);
    EXPECT_NEAR(none.distance, 0.5, 1e-6);
    cast.direction[1] = 0.0;
    expectRefused(api()->cast_shapes(m_world, &cast, 1, nullptr, &none), RUBBLE_ERROR_ARGUMENT, "direction");
    expectRefused(api()->cast_rays(m_world, nullptr, 1, nullptr, &none), RUBBLE_ERROR_NULL, "rays");
}

TEST_F(Abi, ACharacterWalksIntoWaterInATrigger) {
    auto person = sized<rubble_character_settings>();
    person.position[0] = person.position[2] = 0.85, person.position[1] = 1.05;
    ASSERT_EQ(api()->add_character(m_world, &person), RUBBLE_OK) << api()->get_last_error();
    const double square[8] = {-5, -5, 5, -5, 5, 5, -5, 5};
    auto water = sized<rubble_water_settings>();
    water.outline = square, water.outline_count = 4, water.surface_height = 0.5, water.depth = 30.0;
    ASSERT_EQ(api()->add_water(m_world, &water), RUBBLE_OK) << api()->get_last_error();
    auto trigger = sized<rubble_trigger_settings>();
    trigger.kind = RUBBLE_TRIGGER_SPHERE, trigger.position[1] = 0.9, trigger.radius = 3.0;
    ASSERT_EQ(api()->add_trigger(m_world, &trigger), RUBBLE_OK) << api()->get_last_error();
    for (int i = 0; i < 30; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    rubble_character_state state = {};
    uint32_t count = 0;
    ASSERT_EQ(api()->get_character_states(m_world, &state, 1, &count), RUBBLE_OK);
    ASSERT_EQ(count, 1u);
    EXPECT_TRUE(state.flags & RUBBLE_CHARACTER_GROUNDED);
    EXPECT_NEAR(state.position[1], 1.0, 0.03);
    auto move = sized<rubble_character_move>();
    move.character = state.character;
    move.desired_velocity[0] = 3.0;
    ASSERT_EQ(api()->move_character(m_world, &move), RUBBLE_OK) << api()->get_last_error();
    for (int i = 0; i < 90; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->get_character_states(m_world, &state, 1, &count), RUBBLE_OK);
    EXPECT_GT(state.position[0], 1.7);
    EXPECT_TRUE(state.flags & RUBBLE_CHARACTER_SWIMMING);
    rubble_character_state alone = {};
    ASSERT_EQ(api()->get_character_state(m_world, state.character, &alone), RUBBLE_OK);
    EXPECT_EQ(alone.position[0], state.position[0]);
    EXPECT_EQ(alone.flags, state.flags);
    expectRefused(api()->get_character_state(m_world, 0, &alone), RUBBLE_ERROR_STALE, "character");

    const rubble_explosion explosion = tableExplosion();  // pieces of the table move inside the trigger
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->get_trigger_events(m_world, nullptr, 0, &count), RUBBLE_OK);
    EXPECT_GT(count, 0u);
    std::vector<rubble_trigger_event> events(count);
    ASSERT_EQ(api()->get_trigger_events(m_world, events.data(), count, &count), RUBBLE_OK);
    EXPECT_EQ(events[0].entered, 1u);
    uint32_t inside = 0;
    ASSERT_EQ(api()->get_trigger_bodies(m_world, events[0].trigger, nullptr, 0, &inside), RUBBLE_OK);
    EXPECT_EQ(inside, count);

    auto collision = sized<rubble_collision_filter>();
    expectRefused(api()->set_collision_filter(m_world, &collision), RUBBLE_ERROR_STALE, "shape");
    auto round = sized<rubble_collision_shape>();
    expectRefused(api()->set_collision_shape(m_world, &round), RUBBLE_ERROR_STALE, "shape");
    round.kind = 5;
    expectRefused(api()->set_collision_shape(m_world, &round), RUBBLE_ERROR_ARGUMENT, "kind");
    EXPECT_EQ(api()->remove_character(m_world, state.character), RUBBLE_OK);
    EXPECT_EQ(api()->remove_trigger(m_world, events[0].trigger), RUBBLE_OK);
    uint64_t lake = 0;
    ASSERT_EQ(api()->get_waters(m_world, &lake, 1, &count), RUBBLE_OK);
    EXPECT_EQ(api()->remove_water(m_world, lake), RUBBLE_OK);
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->get_triggers(m_world, nullptr, 0, &count), RUBBLE_OK);
    EXPECT_EQ(count, 0u);
    expectRefused(api()->move_character(m_world, &move), RUBBLE_ERROR_STALE, "character");
}

}  // namespace
}  // namespace rubble
