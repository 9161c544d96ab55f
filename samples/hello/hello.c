/* The smallest host: it loads a level, blows a hole into it and prints what came off. It needs rubble.h and librubble.
 *     hello LEVEL.rubble|LEVEL.vox
 *     hello LEVEL.vdb PATH-OF-rubble-vdb */
#include <rubble/rubble.h>
#include <stdio.h>
#include <stdlib.h>

static const rubble_api* api;

static void check(rubble_result result) {
    if (result == RUBBLE_OK) return;
    fprintf(stderr, "hello: error %d: %s\n", (int)result,
            api ? api->get_last_error() : "librubble and rubble.h are of different versions");
    exit(1);
}

/* Casts rays straight down onto the middle of each shape until one hits. */
static rubble_hit find_roof(rubble_world world) {
    const double down[3] = {0.0, -1.0, 0.0};
    rubble_hit hit = {0};
    rubble_shape_state* shapes;
    uint32_t count, i;
    check(api->get_shape_states(world, 0, NULL, 0, &count));
    shapes = malloc((count ? count : 1) * sizeof *shapes);
    check(api->get_shape_states(world, 0, shapes, count, &count));
    for (i = 0; i < count && !hit.hit; ++i) {
        const double half = 0.5 * shapes[i].voxel_size;
        const double above[3] = {shapes[i].position[0] + half * shapes[i].size[0], 500.0,
                                 shapes[i].position[2] + half * shapes[i].size[2]};
        check(api->cast_ray(world, above, down, 1000.0, &hit));
    }
    free(shapes);
    return hit;
}

static void print_poses(rubble_world world) {
    rubble_body_state* bodies;
    uint32_t count, i, moving = 0;
    check(api->get_body_states(world, NULL, 0, &count));
    bodies = malloc((count ? count : 1) * sizeof *bodies);
    check(api->get_body_states(world, bodies, count, &count));
    for (i = 0; i < count; ++i) moving += !(bodies[i].flags & (RUBBLE_BODY_STATIC | RUBBLE_BODY_ASLEEP));
    printf("%u bodies, %u moving\n", (unsigned)count, (unsigned)moving);
    free(bodies);
}

int main(int argc, char** argv) {
    rubble_world world;
    rubble_explosion explosion = {.struct_size = sizeof explosion};
    rubble_events events = {.struct_size = sizeof events};
    rubble_voxel_accounting voxels = {.struct_size = sizeof voxels};
    rubble_hit roof;
    uint64_t hash;
    int step, i;
    if (argc < 2) {
        fprintf(stderr, "usage: hello LEVEL.rubble|LEVEL.vox, or hello LEVEL.vdb PATH-OF-rubble-vdb\n");
        return 2;
    }
    check(rubble_get_api(RUBBLE_VERSION, &api));
    check(api->create_world(NULL, &world));
    check(api->load_level(world, argv[1], argc > 2 ? argv[2] : NULL));
    check(api->step(world));

    roof = find_roof(world);
    if (!roof.hit) {
        fprintf(stderr, "hello: the level is empty\n");
        return 1;
    }
    for (i = 0; i < 3; ++i) explosion.position[i] = roof.position[i];
    explosion.size = 1.0;
    check(api->explode(world, &explosion));

    for (step = 0; step < 60; ++step) {
        check(api->step(world));
        check(api->get_events(world, &events));
        for (i = 0; i < (int)events.removed_count; ++i)
            printf("step %u: %u voxels of colour #%02x%02x%02x removed\n", (unsigned)events.step,
                   (unsigned)events.removed[i].count, events.removed[i].color[0], events.removed[i].color[1],
                   events.removed[i].color[2]);
        if (events.split_count)
            printf("step %u: %u pieces came off\n", (unsigned)events.step, (unsigned)events.split_count);
    }
    print_poses(world);
    check(api->get_voxel_accounting(world, &voxels));
    printf("%u voxels = %u standing + %u in pieces + %u removed\n", (unsigned)voxels.imported,
           (unsigned)voxels.standing, (unsigned)voxels.in_pieces, (unsigned)voxels.removed);
    check(api->get_state_hash(world, &hash));
    printf("state %08x%08x\n", (unsigned)(hash >> 32), (unsigned)hash);
    check(api->destroy_world(world));
    return 0;
}
