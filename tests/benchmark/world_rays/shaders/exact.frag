// The renderer's walk.
#include "lib/frame.glsl"
#include "lib/shadow_trace.glsl"
bool traceCells(vec3 origin, vec3 direction, float tMax) {
    float t;
    return shadowTrace(origin * kShadowCell, direction, tMax * kShadowCell, t);
}
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
