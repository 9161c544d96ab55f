/* What the two sources of the host `everything` share. */
#include <rubble/rubble.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const rubble_api* api;
extern rubble_world world; /* in use */

/* What bodies and shapes are beside their voxels. In everything_more.c, as the next four. */
void use_properties(void);
/* What a host hears. */
void use_reports(void);
/* Copies of bricks, for a host that draws for itself. */
void use_bricks(void);
/* Particles that a host throws and lists. */
void use_particles(void);
/* A world that the host's physics moves. */
void use_host_physics(void);

/* Ends the program if something is not good. */
static inline void check(int good, const char* what) {
    if (good) return;
    fprintf(stderr, "%s: %s\n", what, api ? api->get_last_error() : "no table");
    exit(1);
}
#define CHECK(condition) check(condition, #condition)
#define OK(call) check((call) == RUBBLE_OK, #call)

/* So many steps of the world. */
static inline void steps(int count) {
    while (count-- > 0) OK(api->step(world));
}

/* A body at a place in metres; flags: RUBBLE_BODY_... */
static inline rubble_body make_body(double x, double y, double z, uint32_t flags) {
    rubble_body_settings settings = {.struct_size = sizeof settings};
    rubble_body out;
    settings.flags = flags;
    settings.position[0] = x, settings.position[1] = y, settings.position[2] = z;
    OK(api->create_body(world, &settings, &out));
    return out;
}

/* A full box of x * y * z cells of one palette index. */
static inline rubble_shape make_box(rubble_body body, int32_t x, int32_t y, int32_t z, uint32_t index) {
    rubble_shape_settings settings = {.struct_size = sizeof settings};
    rubble_shape out;
    settings.body = body, settings.source = RUBBLE_SHAPE_BOX, settings.index = index;
    settings.size[0] = x, settings.size[1] = y, settings.size[2] = z;
    OK(api->create_shape(world, &settings, &out));
    return out;
}
