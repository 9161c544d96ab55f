// The renderer's walk, coarse beyond 1.6 m: as the sky rays of the preset "fast".
#include "lib/frame.glsl"
#include "lib/shadow_trace.glsl"
bool traceCells(vec3 origin, vec3 direction, float tMax) {
    float t;
    return shadowTraceCoarse(origin * kShadowCell, direction, tMax * kShadowCell, 1.6, t);
}
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
