// One ray a pixel through the shadow volume.
#include "lib/frame.glsl"
#include "lib/shadow_trace.glsl"
uniform sampler2D uOrigins;     // w tMax
uniform sampler2D uDirections;
uniform float uExactDistance;      // metres
layout(location = 0) out vec4 outHit;  // x t, y 1 if it hit, z 1 if the one that is coarse beyond uExactDistance does

void main() {
    vec4 origin = texelFetch(uOrigins, ivec2(gl_FragCoord.xy), 0);
    float t;
    vec3 direction = texelFetch(uDirections, ivec2(gl_FragCoord.xy), 0).xyz;
    bool hit = shadowTrace(origin.xyz, direction, origin.w, t);
    float coarseT;
    bool coarse = shadowTraceCoarse(origin.xyz, direction, origin.w, uExactDistance, coarseT);
    outHit = vec4(t, hit ? 1.0 : 0.0, coarse ? 1.0 : 0.0, coarseT);
}
