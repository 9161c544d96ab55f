// No walk at all: what the bench takes itself, reading rays and writing answers, for pixels without a ray too.
bool traceCells(vec3 origin, vec3 direction, float tMax) { return origin.x + direction.x > tMax + 1e9; }
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
