// Teardown's walk, one ray a pixel.
#include "../tests/benchmark/render/shaders/one_ray.glsl"
#include "../tests/benchmark/render/shaders/dense_grid.glsl"
#include "../tests/benchmark/render/shaders/teardown_walk.glsl"

vec4 firstVoxel(vec3 origin, vec3 given) {
    vec3 normal;
    return firstVoxel(origin, given, kNever, normal);
}
