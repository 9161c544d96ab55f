// Share of the sun's disc that each pixel sees, in the alpha of `light`: rays to random points of the disc.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/smoke_shadow.glsl"

uniform int uRayCount;
uniform float uMaxDistance;  // metres

in vec2 uv;
out vec4 light;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    light = vec4(0.0);
    if (s.sky || dot(s.normal, frame.sunDirection.xyz) <= 0.0) return;
    vec3 origin = shadowOrigin(worldFromDepth(uv, s.depth), s.normal);
    for (int i = 0; i < uRayCount; ++i) {
        vec2 u = blueNoise(pixel, 0, frame.counters.x * uRayCount + i);
        float t;
        if (!shadowTrace(origin, coneDirection(frame.sunDirection.xyz, frame.sunDirection.w, u), uMaxDistance, t)) light.a += 1.0;
    }
    light.a *= sunThroughSmoke(origin) / float(uRayCount);
}
