/* A host that uses every function of rubble.h: what a world can do is reachable from C. It begins with an empty world,
 * makes all that it needs, and prints "good": everything FOLDER-FOR-ITS-FILES. */
#include "everything.h"

const rubble_api* api;
rubble_world world;
static char game_path[1024], log_path[1024];

static void drop_log(void* user, int32_t level, const char* message) {
    (void)user, (void)level, (void)message;
}

/* Voxels: a wall that is written, read, carved, broken, painted, blown up, resized, trimmed and split. */
static void use_voxels(void) {
    const rubble_body wall_body = make_body(0.0, 0.0, 0.0, RUBBLE_BODY_STATIC);
    const rubble_shape wall = make_box(wall_body, 40, 30, 4, 7);
    rubble_voxel_box box = {.struct_size = sizeof box};
    rubble_carve carve = {.struct_size = sizeof carve};
    rubble_break hit = {.struct_size = sizeof hit};
    rubble_paint paint = {.struct_size = sizeof paint};
    rubble_explosion explosion = {.struct_size = sizeof explosion};
    rubble_resize resize = {.struct_size = sizeof resize};
    rubble_collision_filter filter = {.struct_size = sizeof filter};
    rubble_collision_shape round = {.struct_size = sizeof round};
    rubble_voxel_accounting sums = {.struct_size = sizeof sums};
    rubble_events events = {.struct_size = sizeof events};
    const uint8_t cells[8] = {3, 3, 3, 3, 3, 3, 3, 3};
    uint8_t back[8];
    uint64_t count;
    box.shape = wall, box.size[0] = box.size[1] = box.size[2] = 2;
    OK(api->write_voxels(world, &box, cells, sizeof cells));
    steps(1);
    OK(api->read_voxels(world, &box, back, sizeof back, &count));
    CHECK(count == 8 && memcmp(cells, back, 8) == 0);
    carve.position[0] = 2.0, carve.position[1] = 2.0, carve.position[2] = 0.2;
    carve.radii[0] = carve.radii[1] = carve.radii[2] = 0.4;
    OK(api->carve(world, &carve));
    hit.position[0] = 1.0, hit.position[1] = 1.5, hit.position[2] = 0.2;
    hit.radii[0] = hit.radii[1] = hit.radii[2] = 0.5;
    OK(api->break_voxels(world, &hit));
    paint.position[0] = 3.0, paint.position[1] = 1.0, paint.position[2] = 0.2;
    OK(api->paint(world, &paint));
    explosion.position[0] = 3.0, explosion.position[1] = 2.0, explosion.position[2] = 0.2;
    OK(api->explode(world, &explosion));
    resize.shape = wall, resize.size[0] = 40, resize.size[1] = 34, resize.size[2] = 4;
    OK(api->resize_shape(world, &resize));
    OK(api->trim_shape(world, wall));
    OK(api->split_shape(world, wall));
    filter.shape = wall, filter.layer = 2;
    OK(api->set_collision_filter(world, &filter));
    round.shape = wall;
    OK(api->set_collision_shape(world, &round));
    steps(1);
    OK(api->get_events(world, &events));
    CHECK(events.removed_count > 0 && events.dust_cloud_count > 0);
    OK(api->get_voxel_accounting(world, &sums));
    CHECK(sums.imported == sums.standing + sums.in_pieces + sums.removed);
}

/* Bodies and shapes: made, merged, pushed, set, listed and destroyed. */
static void use_bodies(void) {
    const rubble_body body = make_body(10.0, 8.0, 0.0, 0);
    const rubble_shape first = make_box(body, 6, 6, 6, 5);
    rubble_shape_settings copy = {.struct_size = sizeof copy};
    rubble_body_change change = {.struct_size = sizeof change};
    rubble_impulse push = {.struct_size = sizeof push};
    rubble_row_list list = {.struct_size = sizeof list};
    rubble_palette_range entries = {.struct_size = sizeof entries};
    rubble_palette_entry wood;
    rubble_material oak = {.struct_size = sizeof oak};
    uint32_t index;
    rubble_body_state state;
    rubble_shape_state shapes[4];
    rubble_refusal refused;
    rubble_shape second, doomed;
    uint32_t count;
    uint64_t same;
    copy.body = body, copy.source = RUBBLE_SHAPE_COPY, copy.copied = first, copy.position[0] = 0.6;
    OK(api->create_shape(world, &copy, &second));
    OK(api->merge_shape(world, second, first));
    copy.position[0] = 5.0;
    OK(api->create_shape(world, &copy, &doomed));
    OK(api->destroy_shape(world, doomed));
    change.body = body, change.fields = RUBBLE_SET_VELOCITY, change.velocity[1] = 2.0;
    OK(api->set_body(world, &change));
    push.body = body, push.impulse[0] = 10.0;
    OK(api->apply_impulse(world, &push));
    steps(1);
    OK(api->get_refusals(world, &refused, 1, &count));
    CHECK(count == 0);
    entries.shape = first, entries.first = 5, entries.count = 1;
    OK(api->get_palette(world, &entries, &wood));
    wood.color[0] = 90, wood.color[1] = 60, wood.color[2] = 30;
    OK(api->set_palette(world, &entries, &wood));
    OK(api->find_material(world, "wood", &index));
    OK(api->get_material(world, index, &oak));
    oak.name = "oak", oak.density = 700;
    OK(api->get_material_count(world, &count));
    OK(api->set_materials(world, count, &oak, 1));
    steps(1);
    OK(api->find_material(world, "oak", &index));
    CHECK(index == count);
    OK(api->get_body_state(world, body, &state));
    CHECK(state.shape_count == 1 && state.velocity[1] > 1.0);
    OK(api->get_body_states(world, NULL, 0, &count));
    CHECK(count >= 2);
    OK(api->get_shape_states(world, body, shapes, 4, &count));
    CHECK(count == 1 && shapes[0].voxel_count == 432);
    OK(api->read_rows(world, &list, NULL, 0, &count));
    CHECK(count >= 2);
    OK(api->translate_handle(world, body, &same));
    CHECK(same == body);
    OK(api->destroy_body(world, body));
}

/* Joints: a wheel, a rope, a hand; and what is added without asking for its handle. */
static void use_joints(void) {
    const rubble_body post = make_body(20.0, 0.0, 0.0, RUBBLE_BODY_STATIC), load = make_body(20.0, 1.0, 0.0, 0);
    const rubble_shape upright = make_box(post, 4, 10, 4, 5), crate = make_box(load, 4, 4, 4, 5);
    rubble_joint_settings settings = {.struct_size = sizeof settings};
    rubble_joint_motor motor = {.struct_size = sizeof motor};
    rubble_drive drive = {.struct_size = sizeof drive};
    rubble_grab grab = {.struct_size = sizeof grab};
    rubble_release release = {.struct_size = sizeof release};
    rubble_joint_state states[8];
    rubble_joint hinge, rope;
    double points[96];
    uint32_t count;
    settings.kind = RUBBLE_JOINT_HINGE, settings.shapes[0] = upright, settings.shapes[1] = crate;
    settings.position[0] = 20.2, settings.position[1] = 1.0, settings.position[2] = 0.2;
    OK(api->create_joint(world, &settings, &hinge));
    settings.kind = RUBBLE_JOINT_ROPE;
    memcpy(settings.rope_end, settings.position, sizeof settings.rope_end);
    settings.rope_length = 2.0;
    OK(api->create_joint(world, &settings, &rope));
    OK(api->add_joint(world, &settings));
    motor.joint = hinge, motor.motor = RUBBLE_MOTOR_SPEED, motor.motor_target = 1.0, motor.motor_max_force = 10.0;
    OK(api->set_joint_motor(world, &motor));
    drive.body = load, drive.throttle = 1.0;
    OK(api->drive_wheels(world, &drive));
    grab.body = load, grab.point[0] = 20.2, grab.point[1] = 1.2, grab.point[2] = 0.2;
    memcpy(grab.target, grab.point, sizeof grab.target);
    OK(api->grab_body(world, &grab));
    steps(2);
    OK(api->get_joint_states(world, states, 8, &count));
    CHECK(count == 4 && states[0].joint == hinge);
    OK(api->get_rope_points(world, rope, points, 96, &count));
    OK(api->get_ropes(world, NULL, 0, &count));
    OK(api->release_body(world, &release));
    OK(api->detach_joint(world, rope, crate));
    OK(api->remove_joint(world, hinge));
    steps(1);
    OK(api->get_joint_states(world, states, 8, &count));
    CHECK(count == 2);
}

/* Water, triggers and characters. */
static void use_regions(void) {
    const double corners[8] = {28, -2, 32, -2, 32, 2, 28, 2};
    rubble_water_settings pool = {.struct_size = sizeof pool};
    rubble_trigger_settings region = {.struct_size = sizeof region};
    rubble_character_settings walker = {.struct_size = sizeof walker};
    rubble_character_move move = {.struct_size = sizeof move};
    rubble_character_teleport teleport = {.struct_size = sizeof teleport};
    rubble_trigger_event events[8];
    rubble_character_state states[4];
    uint64_t rows[4];
    rubble_water water;
    rubble_trigger trigger;
    rubble_character character;
    uint32_t count;
    pool.outline = corners, pool.outline_count = 4;
    OK(api->add_water(world, &pool));
    OK(api->create_water(world, &pool, &water));
    region.position[0] = 35.0, region.position[1] = 1.0;
    OK(api->add_trigger(world, &region));
    OK(api->create_trigger(world, &region, &trigger));
    walker.position[1] = 5.0, walker.position[0] = 40.0;
    OK(api->add_character(world, &walker));
    OK(api->create_character(world, &walker, &character));
    move.character = character, move.desired_velocity[0] = 1.0;
    OK(api->move_character(world, &move));
    teleport.character = character, teleport.position[0] = 42.0, teleport.position[1] = 1.0;
    OK(api->teleport_character(world, &teleport));
    make_box(make_body(34.9, 0.9, 0.0, 0), 2, 2, 2, 5);
    steps(2);
    OK(api->get_waters(world, rows, 4, &count));
    CHECK(count == 2 && (rows[0] == water || rows[1] == water));
    OK(api->get_triggers(world, rows, 4, &count));
    CHECK(count == 2 && (rows[0] == trigger || rows[1] == trigger));
    OK(api->get_trigger_events(world, events, 8, &count));
    OK(api->get_trigger_bodies(world, trigger, rows, 4, &count));
    CHECK(count == 1);
    OK(api->get_character_states(world, states, 4, &count));
    CHECK(count == 2);
    OK(api->remove_water(world, water));
    OK(api->remove_trigger(world, trigger));
    OK(api->remove_character(world, character));
    steps(1);
}

/* Sky, lights and fire. */
static void use_light_and_fire(void) {
    const double low[3] = {-5, -5, -5}, high[3] = {60, 60, 60}, sun[3] = {0.2, 1.0, 0.1};
    rubble_environment sky = {.struct_size = sizeof sky};
    rubble_light_settings bulb = {.struct_size = sizeof bulb};
    rubble_heat heat = {.struct_size = sizeof heat};
    rubble_extinguish water = {.struct_size = sizeof water};
    rubble_light light, rows[4];
    rubble_fire fires[8];
    uint32_t count;
    OK(api->get_environment(world, &sky));
    OK(api->apply_sky_model(&sky, sun));
    sky.gravity[1] = -9.81;
    OK(api->set_environment(world, &sky));
    bulb.flags = RUBBLE_LIGHT_ENABLED, bulb.color[0] = 10.0, bulb.reach = 5.0;
    OK(api->add_light(world, &bulb));
    OK(api->create_light(world, &bulb, &light));
    bulb.light = light, bulb.reach = 6.0;
    OK(api->set_light(world, &bulb));
    heat.flags = RUBBLE_HEAT_IGNITE, heat.radius = 20.0;
    OK(api->heat(world, &heat));
    steps(1);
    OK(api->get_added_lights(world, rows, 4, &count));
    CHECK(count == 2 && rows[1] == light);
    OK(api->get_lights(world, rows, 4, &count));
    OK(api->get_light_settings(world, light, &bulb));
    CHECK(bulb.reach == 6.0);
    OK(api->get_fires(world, fires, 0, &count));
    OK(api->find_closest_fire(world, low, 100.0, fires));
    OK(api->count_fires(world, low, high, &count));
    water.radius = 1.0;
    OK(api->extinguish(world, &water));
    OK(api->remove_fires(world, low, high));
    OK(api->remove_light(world, light));
    steps(1);
}

/* Rays, casts, overlaps and closest points. */
static void use_queries(void) {
    const double origin[3] = {0.5, 0.5, -5.0}, along[3] = {0.0, 0.0, 1.0};
    rubble_ray ray = {{0.5, 0.5, -5.0}, {0.0, 0.0, 1.0}, 50.0, 0.0};
    rubble_shape_cast cast;
    rubble_hit hit;
    uint64_t found[512];
    uint32_t count;
    memset(&cast, 0, sizeof cast);
    OK(api->cast_ray(world, origin, along, 50.0, &hit));
    CHECK(hit.hit == 1);
    OK(api->cast_rays(world, &ray, 1, NULL, &hit));
    CHECK(hit.hit == 1);
    memcpy(cast.shape.position, origin, sizeof origin);
    memcpy(cast.direction, along, sizeof along);
    cast.shape.radius = 0.1, cast.max_distance = 50.0;
    OK(api->cast_shapes(world, &cast, 1, NULL, &hit));
    CHECK(hit.hit == 1);
    cast.shape.radius = 10.0;
    OK(api->overlap_bodies(world, &cast.shape, NULL, found, 512, &count));
    CHECK(count > 0);
    OK(api->overlap_shapes(world, &cast.shape, NULL, found, 512, &count));
    CHECK(count > 0);
    OK(api->find_closest_point(world, origin, 50.0, NULL, &hit));
    CHECK(hit.hit == 1);
}

/* Undo, saves, recordings, levels, prefabs and bounds. */
static void use_files(void) {
    rubble_bounds bounds = {.struct_size = sizeof bounds};
    rubble_prefab prefab = {.struct_size = sizeof prefab};
    rubble_step_stats stats = {.struct_size = sizeof stats};
    uint64_t hash, again, recorded;
    uint32_t count;
    OK(api->set_undo_limit(world, 2));
    steps(1);
    OK(api->add_undo_mark(world));
    make_box(make_body(50.0, 0.0, 0.0, RUBBLE_BODY_STATIC), 5, 5, 5, 5);
    steps(1);
    OK(api->undo(world));
    steps(1);
    OK(api->redo(world));
    OK(api->get_bounds(world, &bounds));
    bounds.rule = RUBBLE_BOUNDS_KEEP;
    OK(api->set_bounds(world, &bounds));
    OK(api->start_recording(world, log_path));
    steps(3);
    OK(api->stop_recording(world));
    OK(api->get_state_hash(world, &hash));
    OK(api->save_game(world, game_path));
    OK(api->play_recording(world, log_path, &recorded));
    OK(api->get_state_hash(world, &again));
    CHECK(recorded == 3 && hash == again);
    OK(api->load_game(world, game_path));
    OK(api->get_state_hash(world, &again));
    CHECK(hash == again);
    OK(api->get_step_stats(world, &stats));
    prefab.path = game_path;
    CHECK(api->create_prefab(world, &prefab, NULL, 0, &count) == RUBBLE_ERROR_FILE); /* a game is no level */
    CHECK(api->load_level(world, game_path, NULL) == RUBBLE_ERROR_FILE);
}

/* The same from and to memory. */
static void use_memory(void) {
    uint64_t size, hash, again, steps_played;
    double progress;
    uint8_t* data;
    OK(api->get_state_hash(world, &hash));
    OK(api->save_game_data(world, NULL, 0, &size));
    data = malloc(size);
    CHECK(data != NULL);
    OK(api->save_game_data(world, data, size, &size));
    OK(api->load_game_data(world, data, size));
    OK(api->get_state_hash(world, &again));
    CHECK(hash == again);
    CHECK(api->load_level_data(world, data, size) == RUBBLE_ERROR_FILE); /* a game is no level, nor a recording */
    CHECK(api->play_recording_data(world, data, size, &steps_played) == RUBBLE_ERROR_FILE);
    free(data);
    OK(api->start_loading(world, "missing.rubble", NULL));
    OK(api->get_loading_progress(world, &progress));
    CHECK(progress >= 0.0 && progress <= 1.0);
    CHECK(api->finish_loading(world) == RUBBLE_ERROR_FILE);
}

/* A world that follows this one. */
static void use_deltas(void) {
    rubble_world other;
    uint64_t size, hash, again;
    uint8_t* data;
    OK(api->create_world(NULL, &other));
    OK(api->keep_deltas(world, 1));
    OK(api->save_game_data(world, NULL, 0, &size));
    data = malloc(size);
    CHECK(data != NULL);
    OK(api->save_game_data(world, data, size, &size));
    OK(api->load_game_data(other, data, size));
    free(data);
    make_box(make_body(90.0, 0.0, 0.0, RUBBLE_BODY_STATIC), 5, 5, 5, 5);
    steps(2);
    OK(api->take_deltas(world, NULL, 0, &size));
    data = malloc(size);
    CHECK(data != NULL);
    OK(api->take_deltas(world, data, size, &size));
    OK(api->apply_deltas(other, data, size));
    free(data);
    OK(api->get_resolved_hash(world, &hash));
    OK(api->get_resolved_hash(other, &again));
    CHECK(hash == again);
    OK(api->keep_deltas(world, 0));
    OK(api->destroy_world(other));
}

/* What a host says of objects: names, tags and numbers, by which it finds them; origins of pieces; settings. */
static void use_objects(void) {
    const rubble_body body = make_body(60.0, 2.0, 0.0, RUBBLE_BODY_STATIC);
    const rubble_shape shape = make_box(body, 12, 12, 2, 7);
    rubble_settings settings = {.struct_size = sizeof settings};
    rubble_carve carve = {.struct_size = sizeof carve};
    rubble_shape parent, root, pieces[8];
    uint64_t found[8], value;
    uint32_t count;
    char text[64];
    OK(api->get_settings(world, &settings));
    settings.flags |= RUBBLE_SETTING_KEEP_ORIGINS;
    settings.physics_preset = RUBBLE_PHYSICS_FAST;
    OK(api->set_settings(world, &settings));
    OK(api->set_physics_threads(world, 2));
    OK(api->set_name(world, shape, "door"));
    OK(api->set_tag(world, shape, "lock", "red"));
    OK(api->set_tag(world, shape, "old", NULL));
    OK(api->remove_tag(world, shape, "old"));
    OK(api->set_user_value(world, shape, 42));
    steps(1);
    OK(api->get_name(world, shape, text, sizeof text, &count));
    CHECK(count == 5 && strcmp(text, "door") == 0);
    OK(api->get_tag(world, shape, "lock", text, sizeof text, &count));
    CHECK(count == 4 && strcmp(text, "red") == 0);
    OK(api->get_tags(world, shape, text, sizeof text, &count));
    CHECK(count == 9 && strcmp(text, "lock=red") == 0);
    OK(api->get_user_value(world, shape, &value));
    CHECK(value == 42);
    OK(api->find_by_name(world, RUBBLE_KIND_SHAPE, "door", found, 8, &count));
    CHECK(count == 1 && found[0] == shape);
    OK(api->find_by_tag(world, RUBBLE_KIND_SHAPE, "lock", NULL, found, 8, &count));
    CHECK(count == 1 && found[0] == shape);
    OK(api->get_objects(world, RUBBLE_KIND_BODY, NULL, 0, &count));
    CHECK(count >= 1);
    OK(api->get_objects_of(world, body, RUBBLE_KIND_SHAPE, found, 8, &count));
    CHECK(count == 1 && found[0] == shape);
    carve.brush = RUBBLE_BRUSH_BOX, carve.shape = shape; /* between its lower and its upper half */
    carve.position[0] = 60.6, carve.position[1] = 2.6, carve.position[2] = 0.1;
    carve.half_size[0] = carve.half_size[2] = 2.0, carve.half_size[1] = 0.06;
    OK(api->carve(world, &carve));
    steps(1);
    OK(api->get_pieces(world, shape, pieces, 8, &count));
    CHECK(count == 1);
    OK(api->get_origin(world, pieces[0], &parent, &root));
    CHECK(parent == shape && root == shape);
    OK(api->get_user_value(world, pieces[0], &value));
    CHECK(value == 42);
}

/* Without a GL context there is no renderer, and every call for one says so. */
static void use_renderer(void) {
    rubble_renderer_settings settings = {.struct_size = sizeof settings};
    rubble_view view = {.struct_size = sizeof view};
    rubble_draw_stats stats = {.struct_size = sizeof stats};
    rubble_renderer renderer = 1;
    settings.shader_folder = "shaders";
    CHECK(api->create_renderer(world, &settings, &renderer) == RUBBLE_ERROR_GL && renderer == 0);
    CHECK(api->draw(renderer, &view) == RUBBLE_ERROR_STALE);
    CHECK(api->set_debug_view(renderer, "normal") == RUBBLE_ERROR_STALE);
    CHECK(api->get_draw_stats(renderer, &stats) == RUBBLE_ERROR_STALE);
    CHECK(api->destroy_renderer(renderer) == RUBBLE_ERROR_STALE);
}

int main(int argc, char** argv) {
    rubble_host host = {.struct_size = sizeof host};
    if (argc != 2) return 2;
    snprintf(game_path, sizeof game_path, "%s/game.rubble", argv[1]);
    snprintf(log_path, sizeof log_path, "%s/game.rubblelog", argv[1]);
    CHECK(rubble_get_api(RUBBLE_VERSION, &api) == RUBBLE_OK);
    host.log = drop_log;
    OK(api->set_host(&host));
    OK(api->create_world(NULL, &world));
    use_voxels();
    use_bodies();
    use_joints();
    use_regions();
    use_light_and_fire();
    use_queries();
    use_objects();
    use_properties();
    use_reports();
    use_bricks();
    use_particles();
    use_files();
    use_memory();
    use_deltas();
    use_host_physics();
    use_renderer();
    OK(api->destroy_world(world));
    puts("good");
    return 0;
}
