// What the frame's own walk takes to set up and make one step: the least that a ray can take.
#include "lib/frame.glsl"
#include "lib/shadow_trace.glsl"
bool traceCells(vec3 origin, vec3 direction, float tMax) {
    float t;
    return shadowTrace(origin * kShadowCell, direction, tMax * 1.0e-9, t);
}
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
