// The renderer's walk with its set-up and one step: the least that a ray can cost.
#include "lib/frame.glsl"
#include "lib/shadow_trace.glsl"
bool traceCells(vec3 origin, vec3 direction, float tMax) {
    float t;
    return shadowTrace(origin * kShadowCell, direction, tMax * 1.0e-9, t);
}
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
