/* What the examples of the reference share: the helpers of the cookbook, and a scene. Each EXAMPLE(FUNCTION) begins
 * with a new world: the cookbook's floor, a wall of brick and a wooden crate before it. docs/api shows it at that
 * function. */
#ifndef RUBBLE_EXAMPLE_H
#define RUBBLE_EXAMPLE_H
#include "samples/cookbook/cookbook.h"

#define EXAMPLE(function) static void example_of_##function(void)

static rubble_shape wall;      /* static, x -2 to 2, y 0 to 2.5, z 0 to 0.3 m: 40 x 25 x 3 voxels of 10 cm */
static rubble_body crate;      /* free, at rest on the floor, x -0.4 to 0.4, y 0 to 0.8, z -2 to -1.2 m */
static rubble_shape crate_box; /* the crate's shape, 8 x 8 x 8 voxels */
static unsigned framebuffer;   /* of the host's GL context, which is current: 64 x 36 pixels */
static uint8_t bytes[1 << 20];

/* Reads a file into `bytes`; returns its size. */
static inline uint64_t read_file(const char* path) {
    FILE* file = fopen(path, "rb");
    size_t size;
    require(file != NULL, path);
    size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    return size;
}
#endif
