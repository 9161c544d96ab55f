// The renderer's own walk, one ray a pixel through body 0.
#include "lib/voxel_walk.glsl"
#include "../tests/benchmark/render/shaders/one_ray.glsl"

vec4 firstVoxel(vec3 originCells, vec3 direction) {
    VoxelHit hit = walkVoxels(readLayout(0), originCells, direction, 0.0, kFarthest, kStopAtSolid);
    return hit.hit ? vec4(hit.cell, hit.t) : vec4(-1.0);
}
