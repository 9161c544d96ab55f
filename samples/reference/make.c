/* Examples: making things, and reading what there is. */
#include "example.h"

EXAMPLE(create_body) {
    rubble_body_settings settings = {.struct_size = sizeof settings, .position = {0, 5, 0}}; /* free, awake */
    rubble_shape_settings box = {.struct_size = sizeof box, .source = RUBBLE_SHAPE_BOX, .size = {5, 5, 5}};
    rubble_shape shape;
    OK(api->create_body(world, &settings, &box.body)); /* the handle holds at once */
    box.index = WOOD;
    OK(api->create_shape(world, &box, &shape));
    OK(api->step(world)); /* now the box is there, and falls */
    require(state_of(box.body).velocity[1] < 0, "it falls");
}

EXAMPLE(create_shape) {
    const rubble_voxel_run rows[3] = {{16, BRICK}, {16, 0}, {16, GLASS}}; /* cells, x fastest, then y, then z */
    rubble_shape_settings settings = {.struct_size = sizeof settings, .source = RUBBLE_SHAPE_RUNS, .size = {16, 3, 1}};
    rubble_shape_state state;
    rubble_shape shape;
    uint32_t count;
    settings.body = make_body(4, 0, 0, RUBBLE_BODY_STATIC); /* cookbook.h */
    settings.runs = rows, settings.count = 3;
    settings.voxel_size = 0.05;
    OK(api->create_shape(world, &settings, &shape));
    steps(1);
    OK(api->get_shape_states(world, settings.body, &state, 1, &count));
    require(count == 1 && state.voxel_count == 32, "two rows of sixteen");
}

EXAMPLE(create_joint) {
    rubble_joint_settings settings = {.struct_size = sizeof settings, .kind = RUBBLE_JOINT_BALL};
    rubble_joint joint;
    settings.shapes[0] = crate_box;                          /* shapes[1] is 0: the world */
    settings.position[1] = 0.8, settings.position[2] = -1.6; /* at the crate's top */
    OK(api->create_joint(world, &settings, &joint));
}

EXAMPLE(create_light) {
    rubble_light_settings settings = {.struct_size = sizeof settings, .kind = RUBBLE_LIGHT_SPHERE};
    rubble_light light;
    settings.flags = RUBBLE_LIGHT_ENABLED;
    settings.position[1] = 3, settings.reach = 10, settings.radius = 0.1;
    settings.color[0] = 20, settings.color[1] = 16, settings.color[2] = 10;
    OK(api->create_light(world, &settings, &light)); /* with .shape set it would move with that */
}

EXAMPLE(create_water) {
    const double corners[8] = {4, -3, 8, -3, 8, 3, 4, 3}; /* x and z of each */
    rubble_water_settings pool = {.struct_size = sizeof pool, .outline = corners, .outline_count = 4};
    rubble_water water;
    pool.surface_height = 1.5, pool.depth = 1.5;
    OK(api->create_water(world, &pool, &water));
}

EXAMPLE(create_trigger) {
    rubble_trigger_settings goal = {.struct_size = sizeof goal, .kind = RUBBLE_TRIGGER_BOX, .position = {0, 1, -4}};
    rubble_trigger trigger;
    goal.half_size[0] = goal.half_size[1] = goal.half_size[2] = 1;
    OK(api->create_trigger(world, &goal, &trigger));
}

EXAMPLE(create_character) {
    rubble_character_settings settings = {.struct_size = sizeof settings, .position = {3, 0, -3}}; /* of the feet */
    rubble_character player;
    OK(api->create_character(world, &settings, &player));
}

EXAMPLE(create_prefab) {
    rubble_prefab prefab = {.struct_size = sizeof prefab, .path = "level.rubble", .position = {6, 0, 6}};
    rubble_prefab_row rows[16];
    uint32_t count;
    OK(api->create_prefab(world, &prefab, rows, 16, &count));
    require(rows[0].kind == RUBBLE_PREFAB_BODY && rows[1].handle != 0, "its bodies come first");
}

EXAMPLE(get_refusals) {
    rubble_shape_settings empty = {.struct_size = sizeof empty, .source = RUBBLE_SHAPE_EMPTY, .size = {4, 4, 4}};
    rubble_refusal refused;
    rubble_shape shape;
    uint32_t count;
    empty.body = crate;
    OK(api->create_shape(world, &empty, &shape)); /* and no write_voxels() */
    steps(1);
    OK(api->get_refusals(world, &refused, 1, &count));
    require(count == 1 && refused.handle == shape, refused.reason);
}

EXAMPLE(get_body_states) {
    rubble_body_state rows[64];
    uint32_t count, i, awake = 0;
    OK(api->get_body_states(world, rows, 64, &count)); /* more than 64: RUBBLE_ERROR_CAPACITY */
    for (i = 0; i < count; ++i) awake += !(rows[i].flags & (RUBBLE_BODY_STATIC | RUBBLE_BODY_ASLEEP));
    require(count == 3 && awake <= 1, "the floor, the wall and the crate, which alone may move");
}

EXAMPLE(get_body_state) {
    rubble_body_state state;
    OK(api->get_body_state(world, crate, &state)); /* as the last step left it */
    require(state.position[2] < -1.9 && state.shape_count == 1, "where the crate is");
}

EXAMPLE(get_shape_states) {
    rubble_shape_state rows[4];
    uint32_t count;
    OK(api->get_shape_states(world, crate, rows, 4, &count));
    require(count == 1 && rows[0].shape == crate_box && rows[0].voxel_count == 512, "8 x 8 x 8 voxels");
}

EXAMPLE(get_shape_state) {
    rubble_shape_state state;
    OK(api->get_shape_state(world, crate_box, &state)); /* such as a piece that get_events() has named */
    require(state.body == crate && state.voxel_count == 512, "where it is, and on which body");
}

EXAMPLE(read_rows) {
    rubble_row_list list = {.struct_size = sizeof list, .kind = RUBBLE_ROWS_BODIES};
    rubble_body_state rows[64];
    uint32_t count;
    list.row_size = sizeof(rubble_body_state); /* of this rubble.h, whatever the library's is */
    OK(api->read_rows(world, &list, rows, 64, &count));
    require(count == 3, "the same rows as get_body_states()");
}

EXAMPLE(get_step_stats) {
    rubble_step_stats stats = {.struct_size = sizeof stats};
    OK(api->get_step_stats(world, &stats));
    require(stats.bodies == 1 && stats.physics_ms >= 0, "one body moves; physics took so many milliseconds");
}

EXAMPLE(get_state_hash) {
    rubble_world twin;
    uint64_t mine, other;
    OK(api->create_world(NULL, &twin));
    OK(api->get_state_hash(world, &mine));
    OK(api->get_state_hash(twin, &other));
    require(mine != other, "other worlds have other hashes, equal ones the same");
    OK(api->destroy_world(twin));
}
