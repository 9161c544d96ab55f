/* Meshes, physics and network of the guides' engine. */
#include "my_engine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096 };

const char my_level[] = "guide.vox";

void my_fail(const char* why) {
    fprintf(stderr, "guide: %s\n", why);
    exit(1);
}

void my_log(const char* message) {
    fprintf(stderr, "%s\n", message);
}

int my_player_fires(double position[3]) {
    static int fired;
    position[0] = position[2] = 0.0, position[1] = 0.8;
    return !fired++;
}

int my_receive_shot(double position[3]) {
    return my_player_fires(position);
}

static struct my_shape shapes[MOST];
static uint32_t shape_count, triangle_count;

struct my_shape* my_add(rubble_shape handle) {
    struct my_shape* shape = &shapes[shape_count++ % MOST];
    shape->handle = handle, shape->version = 0;
    return shape;
}

struct my_shape* my_find(rubble_shape handle) {
    uint32_t i;
    for (i = 0; i < MOST; ++i)
        if (shapes[i].handle == handle) return &shapes[i];
    return NULL;
}

void my_remove(rubble_shape handle) {
    struct my_shape* shape = my_find(handle);
    if (shape) shape->handle = 0;
}

void my_drop_meshes(struct my_shape* shape) {
    (void)shape;
}

void my_upload(struct my_shape* shape, const int32_t brick[3], const rubble_mesh_vertex* vertices, uint32_t count) {
    (void)shape, (void)brick, (void)vertices;
    triangle_count += count / 2;
}

void my_place(rubble_shape shape, const double position[3], const double rotation[4]) {
    (void)position, (void)rotation;
    if (!my_find(shape)) my_fail("a shape that nobody has added");
}

uint32_t my_triangle_count(void) {
    return triangle_count;
}

static rubble_rigid_body bodies[MOST];
static uint32_t body_count;

static rubble_rigid_body* body_of(rubble_body handle) {
    uint32_t i;
    for (i = 0; i < body_count; ++i)
        if (bodies[i].body == handle) return &bodies[i];
    return NULL;
}

void my_set_collider(const rubble_rigid_body* body, const rubble_body_box* boxes, uint32_t count) {
    (void)boxes;
    if (count == 0) my_fail("a body without boxes");
    if (!body_of(body->body) && body_count < MOST) bodies[body_count++] = *body;
}

void my_set_motion(const rubble_rigid_body* body) {
    rubble_rigid_body* mine = body_of(body->body);
    if (mine) *mine = *body;
}

void my_remove_body(rubble_body handle) {
    rubble_rigid_body* mine = body_of(handle);
    if (mine) *mine = bodies[--body_count];
}

void my_push(rubble_body handle, const double position[3], const double impulse[3]) {
    rubble_rigid_body* mine = body_of(handle);
    int i;
    (void)position;
    for (i = 0; mine && mine->mass > 0 && i < 3; ++i) mine->velocity[i] += impulse[i] / mine->mass;
}

void my_step_physics(double seconds) {
    uint32_t i, j;
    for (i = 0; i < body_count; ++i) {
        if (bodies[i].flags & RUBBLE_BODY_STATIC) continue;
        bodies[i].velocity[1] = bodies[i].position[1] > 0 ? bodies[i].velocity[1] - 9.81 * seconds : 0;
        for (j = 0; j < 3; ++j) bodies[i].position[j] += bodies[i].velocity[j] * seconds;
    }
}

uint32_t my_get_moved_bodies(rubble_body_state* out, uint32_t capacity) {
    uint32_t i, count = 0;
    for (i = 0; i < body_count && count < capacity; ++i) {
        if (bodies[i].flags & RUBBLE_BODY_STATIC) continue;
        memset(&out[count], 0, sizeof out[count]);
        out[count].body = bodies[i].body;
        memcpy(out[count].position, bodies[i].position, sizeof out[count].position);
        memcpy(out[count].rotation, bodies[i].rotation, sizeof out[count].rotation);
        memcpy(out[count++].velocity, bodies[i].velocity, sizeof out[0].velocity);
    }
    return count;
}

uint32_t my_get_impacts(rubble_impact* out, uint32_t capacity) {
    (void)out, (void)capacity;
    return 0;
}

uint32_t my_body_count(void) {
    return body_count;
}

static struct {
    uint8_t* bytes;
    uint64_t size;
} messages[MOST];
static uint32_t sent, received;

uint8_t* my_buffer(uint64_t size) {
    static uint8_t* buffer;
    static uint64_t room;
    if (size > room && !(buffer = realloc(buffer, room = size))) my_fail("out of memory");
    return buffer;
}

void my_send(const uint8_t* bytes, uint64_t size) {
    messages[sent].bytes = malloc(size + 1), messages[sent].size = size;
    if (!messages[sent].bytes) my_fail("out of memory");
    memcpy(messages[sent++].bytes, bytes, size);
}

const uint8_t* my_receive(uint64_t* size) {
    if (received > 0) free(messages[received - 1].bytes), messages[received - 1].bytes = NULL;
    if (received == sent) return NULL;
    *size = messages[received].size;
    return messages[received++].bytes;
}
