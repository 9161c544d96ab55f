/* Examples: water, triggers, characters. */
#include "example.h"

EXAMPLE(add_water) {
    const double corners[8] = {4, -3, 8, -3, 8, 3, 4, 3}; /* x and z of each */
    rubble_water_settings pool = {.struct_size = sizeof pool, .outline = corners, .outline_count = 4};
    rubble_water waters[4];
    uint32_t count;
    pool.surface_height = 1.5, pool.depth = 1.5;
    OK(api->add_water(world, &pool)); /* create_water() gives its handle at once */
    steps(1);
    OK(api->get_waters(world, waters, 4, &count));
    require(count == 1, "the pool");
    OK(api->remove_water(world, waters[0]));
}

EXAMPLE(add_trigger) {
    rubble_trigger_settings zone = {.struct_size = sizeof zone, .kind = RUBBLE_TRIGGER_SPHERE, .position = {0, 0, -2}};
    rubble_trigger_event events[8];
    rubble_trigger triggers[4];
    rubble_body bodies[8];
    uint32_t count;
    zone.radius = 1;
    OK(api->add_trigger(world, &zone)); /* create_trigger() gives its handle at once */
    steps(1);
    OK(api->get_trigger_events(world, events, 8, &count));
    require(count == 1 && events[0].entered && events[0].body == crate, "the crate is in it");
    OK(api->get_triggers(world, triggers, 4, &count));
    OK(api->get_trigger_bodies(world, triggers[0], bodies, 8, &count));
    require(count == 1 && bodies[0] == crate, "and nothing else that is free");
    OK(api->remove_trigger(world, triggers[0]));
}

EXAMPLE(add_character) {
    rubble_character_settings settings = {.struct_size = sizeof settings, .position = {3, 0, -3}}; /* of the feet */
    rubble_character_state state;
    uint32_t count;
    OK(api->add_character(world, &settings)); /* create_character() gives its handle at once */
    steps(2);
    OK(api->get_character_states(world, &state, 1, &count));
    require(count == 1 && state.flags & RUBBLE_CHARACTER_GROUNDED, "it stands on the floor");
    OK(api->remove_character(world, state.character));
}

EXAMPLE(get_character_state) {
    rubble_character_settings settings = {.struct_size = sizeof settings, .position = {3, 0, -3}};
    rubble_character_state state;
    rubble_character walker;
    OK(api->create_character(world, &settings, &walker));
    steps(2);
    OK(api->get_character_state(world, walker, &state));
    require(state.character == walker && state.flags & RUBBLE_CHARACTER_GROUNDED, "it stands on the floor");
}

EXAMPLE(move_character) {
    rubble_character_settings settings = {.struct_size = sizeof settings, .position = {3, 0, -3}};
    rubble_character_move walk = {.struct_size = sizeof walk, .desired_velocity = {0, 0, 4}};
    rubble_character_state state;
    uint32_t count;
    OK(api->create_character(world, &settings, &walk.character));
    OK(api->move_character(world, &walk)); /* holds until the next such call */
    steps(60);
    OK(api->get_character_states(world, &state, 1, &count));
    require(state.position[2] > 0, "it has walked three metres or more");
}

EXAMPLE(teleport_character) {
    rubble_character_settings settings = {.struct_size = sizeof settings, .position = {3, 0, -3}};
    rubble_character_teleport jump = {.struct_size = sizeof jump, .position = {-5, 0, 5}};
    rubble_character_state state;
    uint32_t count;
    OK(api->create_character(world, &settings, &jump.character));
    OK(api->teleport_character(world, &jump));
    steps(1);
    OK(api->get_character_states(world, &state, 1, &count));
    require(state.position[0] < -4.9, "it is somewhere else");
}
