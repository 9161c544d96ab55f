/* What all recipes share: the table, a world with a floor, bodies of boxes, and an end as soon as a call is refused. */
#ifndef RUBBLE_COOKBOOK_H
#define RUBBLE_COOKBOOK_H
#include <rubble/rubble.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WOOD = 5, CONCRETE = 6, BRICK = 7, METAL = 9, GLASS = 15 }; /* entries of a new shape's palette */
static const rubble_api* api;
static rubble_world world;

#define OK(call) require((call) == RUBBLE_OK, #call)
/* Ends the program, with the last error, unless something holds. */
static inline void require(int holds, const char* what) {
    if (holds) return;
    fprintf(stderr, "%s: %s\n", what, api ? api->get_last_error() : "no table");
    exit(1);
}
/* A body at a place; flags: RUBBLE_BODY_STATIC, or 0. */
static inline rubble_body make_body(double x, double y, double z, uint32_t flags) {
    rubble_body_settings settings = {.struct_size = sizeof settings, .flags = flags, .position = {x, y, z}};
    rubble_body body;
    OK(api->create_body(world, &settings, &body));
    return body;
}
/* A box of voxels of 10 cm on a body, its corner at a place of the body. */
static inline rubble_shape make_box(rubble_body body, double x, double y, double z, int sx, int sy, int sz,
                                    int material) {
    rubble_shape_settings settings = {.struct_size = sizeof settings, .source = RUBBLE_SHAPE_BOX, .body = body};
    rubble_shape shape;
    settings.position[0] = x, settings.position[1] = y, settings.position[2] = z;
    settings.size[0] = sx, settings.size[1] = sy, settings.size[2] = sz, settings.index = (uint32_t)material;
    OK(api->create_shape(world, &settings, &shape));
    return shape;
}
/* Advances by so many sixtieths of a second. */
static inline void steps(int count) {
    while (count-- > 0) OK(api->step(world));
}
/* Where a body is and how it moves. */
static inline rubble_body_state state_of(rubble_body body) {
    rubble_body_state state;
    OK(api->get_body_state(world, body, &state));
    return state;
}
/* The voxels that are gone. */
static inline uint64_t voxels_gone(void) {
    rubble_voxel_accounting sums = {.struct_size = sizeof sums};
    OK(api->get_voxel_accounting(world, &sums));
    return sums.removed;
}
/* An empty world with a floor of concrete, 20 by 20 metres, whose top is at a height of 0. */
static inline void begin(void) {
    require(rubble_get_api(RUBBLE_VERSION, &api) == RUBBLE_OK, "rubble_get_api");
    OK(api->create_world(NULL, &world));
    make_box(make_body(-10, -0.3, -10, RUBBLE_BODY_STATIC), 0, 0, 0, 200, 3, 200, CONCRETE);
    steps(1);
}
#endif
