/* Examples: the table, worlds, levels. */
#include "example.h"

EXAMPLE(rubble_get_api) {
    const rubble_api* table;
    if (rubble_get_api(RUBBLE_VERSION, &table) != RUBBLE_OK) exit(1); /* rubble.h and the library do not fit */
    require(table->version == RUBBLE_VERSION, "the table of this version");
}

EXAMPLE(get_last_error) {
    if (api->load_level(world, "missing.rubble", NULL) == RUBBLE_OK) exit(1);
    require(strstr(api->get_last_error(), "missing.rubble") != NULL, "it names the file");
}

static void write_log(void* user, int32_t level, const char* message) {
    if (level >= RUBBLE_LOG_WARNING) fprintf((FILE*)user, "rubble: %s\n", message);
}
EXAMPLE(set_host) {
    rubble_host host = {.struct_size = sizeof host, .user = stderr, .log = write_log};
    OK(api->set_host(&host)); /* before the first world is made; a renderer also needs gl_get_proc_address */
}

EXAMPLE(create_world) {
    rubble_world_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_WORLD_NO_RENDERER};
    rubble_world server;
    settings.physics_threads = 2;
    OK(api->create_world(&settings, &server)); /* null in place of the settings: all defaults */
    OK(api->step(server));
    OK(api->destroy_world(server));
}

EXAMPLE(load_level) {
    uint32_t count;
    OK(api->load_level(world, "level.rubble", NULL));
    OK(api->get_body_states(world, NULL, 0, &count)); /* capacity 0: how many there are */
    require(count > 0, "the bodies of the level");
}

EXAMPLE(load_level_data) {
    const uint64_t size = read_file("level.rubble"); /* or from an archive of the host */
    OK(api->load_level_data(world, bytes, size));
    OK(api->step(world));
}

EXAMPLE(start_loading) {
    double done = 0;
    OK(api->start_loading(world, "level.rubble", NULL));
    while (done < 1) { /* the present level plays on */
        OK(api->step(world));
        OK(api->get_loading_progress(world, &done));
    }
    OK(api->finish_loading(world));
}

EXAMPLE(step) {
    double waiting = 0.04; /* seconds of the host's clock that no step has played yet */
    for (; waiting >= 1.0 / 60; waiting -= 1.0 / 60) OK(api->step(world));
    require(waiting * 60 < 1, "the rest, in steps, is rubble_view.alpha of draw()");
}

EXAMPLE(set_bounds) {
    rubble_bounds bounds = {.struct_size = sizeof bounds, .rule = RUBBLE_BOUNDS_GROUND};
    bounds.low[0] = bounds.low[1] = bounds.low[2] = -50;
    bounds.high[0] = bounds.high[1] = bounds.high[2] = 50;
    OK(api->set_bounds(world, &bounds));
    steps(1);
    OK(api->get_bounds(world, &bounds));
    require(bounds.rule == RUBBLE_BOUNDS_GROUND && bounds.low[0] == -50, "the bounds in use");
}

EXAMPLE(set_settings) {
    rubble_settings settings = {.struct_size = sizeof settings};
    OK(api->get_settings(world, &settings)); /* zeros are values: read all, change some, set all */
    settings.flags |= RUBBLE_SETTING_STRESS;
    settings.min_piece_voxels = 8;
    OK(api->set_settings(world, &settings));
}

EXAMPLE(set_physics_threads) {
    OK(api->set_physics_threads(world, 4)); /* results do not depend on it */
    OK(api->step(world));
}

EXAMPLE(get_layers) {
    uint32_t layers;
    OK(api->get_layers(&layers));
    require(layers & RUBBLE_LAYER_PHYSICS, "worlds of this library move their bodies themselves");
}
