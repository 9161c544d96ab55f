#include "samples/hosts/support/yard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double kFieldOfView = 1.05, kNear = 0.1, kFar = 200.0; /* radians, metres */

void yard_check(const struct yard* yard, rubble_result result, const char* what) {
    if (result == RUBBLE_OK) return;
    fprintf(stderr, "%.*s: error %d: %s\n", (int)strcspn(what, "("), what, (int)result,
            yard->api ? yard->api->get_last_error() : "librubble is of another version than rubble.h");
    exit(1);
}

#define CHECK(call) yard_check(yard, yard->api->call, #call)

void yard_open(struct yard* yard, const char* level, const rubble_host* host) {
    rubble_world_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_WORLD_WAIT_FOR_SHADOW};
    yard_check(yard, rubble_get_api(RUBBLE_VERSION, &yard->api), "rubble_get_api");
    CHECK(set_host(host));
    CHECK(create_world(&settings, &yard->world));
    yard_enter(yard, level, NULL, yard->api, yard->world);
}

void yard_enter(struct yard* yard, const char* level, const struct yard_start* start, const rubble_api* api,
                rubble_world world) {
    static const struct yard_start usual = {{0.6, 0.0, 4.6}, 0.1, -0.05};
    memset(yard, 0, sizeof *yard);
    yard->api = api, yard->world = world, yard->level = level, yard->start = start ? *start : usual;
    yard_restart(yard);
}

void yard_restart(struct yard* yard) {
    rubble_character_settings player = {.struct_size = sizeof player};
    memcpy(player.position, yard->start.position, sizeof player.position);
    CHECK(load_level(yard->world, yard->level, NULL));
    CHECK(create_character(yard->world, &player, &yard->player));
    yard->yaw = yard->start.yaw, yard->pitch = yard->start.pitch;
    CHECK(step(yard->world));
}

void yard_walk(struct yard* yard, double forward, double right, int jump) {
    rubble_character_move move = {.struct_size = sizeof move, .character = yard->player};
    move.flags = jump ? RUBBLE_MOVE_JUMP : 0;
    move.desired_velocity[0] = right * cos(yard->yaw) - forward * sin(yard->yaw);
    move.desired_velocity[2] = -right * sin(yard->yaw) - forward * cos(yard->yaw);
    CHECK(move_character(yard->world, &move));
}

static rubble_hit find_target(struct yard* yard) {
    const double direction[3] = {-sin(yard->yaw) * cos(yard->pitch), sin(yard->pitch),
                                 -cos(yard->yaw) * cos(yard->pitch)};
    rubble_hit hit;
    CHECK(cast_ray(yard->world, yard->position, direction, 100.0, &hit));
    return hit;
}

static void make_hole(struct yard* yard, const double position[3]) {
    rubble_break hole = {.struct_size = sizeof hole, .radii = {1.0, 0.8, 0.4}, .seed = (uint32_t)yard->steps};
    memcpy(hole.position, position, sizeof hole.position);
    CHECK(break_voxels(yard->world, &hole));
}

static void make_explosion(struct yard* yard, const double position[3], double size) {
    rubble_explosion explosion = {.struct_size = sizeof explosion, .size = size};
    memcpy(explosion.position, position, sizeof explosion.position);
    CHECK(explode(yard->world, &explosion));
}

void yard_shoot(struct yard* yard) {
    const rubble_hit hit = find_target(yard);
    if (hit.hit) make_hole(yard, hit.position);
}

void yard_explode(struct yard* yard) {
    const rubble_hit hit = find_target(yard);
    if (hit.hit) make_explosion(yard, hit.position, 1.5);
}

void yard_play_script(struct yard* yard) {
    static const double hole[3] = {-0.9, 1.4, -0.8}, wall[3] = {-1.9, 0.7, -0.8}, tower[3] = {-3.3, 0.3, 0.0};
    switch (yard->steps % SCRIPT_CYCLE) {
        case 0:
            if (yard->steps > 0) yard_restart(yard);
            break;
        case SCRIPT_HOLE:
            make_hole(yard, hole);
            break;
        case SCRIPT_EXPLOSION:
            make_explosion(yard, wall, 1.5);
            break;
        case SCRIPT_FELLED:
            make_explosion(yard, tower, 2.0);
            break;
        default:
            break;
    }
}

const char* yard_image_name(const struct yard* yard, uint64_t end) {
    if (yard->steps == 2) return "1_start";
    if (yard->steps == SCRIPT_EXPLOSION) return "2_hole";
    if (yard->steps == SCRIPT_EXPLOSION + 15) return "3_flying";
    return yard->steps == SCRIPT_CYCLE || (yard->steps == end && end < SCRIPT_CYCLE) ? "4_end" : NULL;
}

void yard_step(struct yard* yard) {
    rubble_events events = {.struct_size = sizeof events};
    rubble_character_state player;
    uint32_t i;
    CHECK(step(yard->world));
    CHECK(get_events(yard->world, &events));
    yard->pieces += events.split_count;
    for (i = 0; i < events.removed_count; ++i) yard->removed += events.removed[i].count;
    CHECK(get_character_state(yard->world, yard->player, &player));
    yard->position[0] = player.position[0];
    yard->position[1] = player.position[1] + 1.6;
    yard->position[2] = player.position[2];
    ++yard->steps;
}

void yard_look(const struct yard* yard, rubble_view* view) {
    const double zoom = 1.0 / tan(0.5 * kFieldOfView);
    memcpy(view->position, yard->position, sizeof view->position);
    view->rotation[0] = cos(0.5 * yard->yaw) * sin(0.5 * yard->pitch);
    view->rotation[1] = sin(0.5 * yard->yaw) * cos(0.5 * yard->pitch);
    view->rotation[2] = -sin(0.5 * yard->yaw) * sin(0.5 * yard->pitch);
    view->rotation[3] = cos(0.5 * yard->yaw) * cos(0.5 * yard->pitch);
    memset(view->projection, 0, sizeof view->projection);
    view->projection[0] = zoom * view->height / view->width;
    view->projection[5] = zoom;
    view->projection[10] = -(kFar + kNear) / (kFar - kNear);
    view->projection[11] = -1.0;
    view->projection[14] = -2.0 * kFar * kNear / (kFar - kNear);
}

void yard_close(struct yard* yard) {
    CHECK(destroy_world(yard->world));
}
