// The frame's own walk, coarse where rays have come far: as the sky rays of the preset "fast".
#include "lib/frame.glsl"
#include "lib/shadow_trace.glsl"
uniform ivec3 uLow;  // cell of the world that the rays call 0
bool traceCells(vec3 origin, vec3 direction, float tMax) {
    float t;
    return shadowTraceCoarse((origin + vec3(uLow)) * kShadowCell, direction, tMax * kShadowCell, 1.6, t);
}
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
