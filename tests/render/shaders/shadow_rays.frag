// One ray a pixel through the shadow volume.
#include "lib/frame.glsl"
#include "lib/shadow_trace.glsl"
uniform sampler2D uOrigins;     // w tMax
uniform sampler2D uDirections;
layout(location = 0) out vec4 outHit;  // x t, y 1 if it hit

void main() {
    vec4 origin = texelFetch(uOrigins, ivec2(gl_FragCoord.xy), 0);
    float t;
    bool hit = shadowTrace(origin.xyz, texelFetch(uDirections, ivec2(gl_FragCoord.xy), 0).xyz, origin.w, t);
    outHit = vec4(t, hit ? 1.0 : 0.0, 0.0, 0.0);
}
