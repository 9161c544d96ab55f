// Soft shadows of the sun: the share of its disc that each pixel sees, in the alpha of `light`. It is the mean
// visibility of rays drawn evenly over the disc's cone (distributed ray tracing: Cook, Porter, Carpenter 1984). A
// penumbra behind an occluder at distance d is d 2 tan(angle) wide.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/moving_bodies.glsl"
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
    vec3 place = placeInShadows(worldFromDepth(uv, s.depth), s.normal, s.moving);
    vec3 origin = surfaceOrigin(place, s.normal, s.fine);
    int i = 0;
    do {
        vec2 u = blueNoise(pixel, 0, frame.counters.x * uRayCount + i);
        float t;
        if (!shadowTrace(origin, coneDirection(frame.sunDirection.xyz, frame.sunDirection.w, u), uMaxDistance, t))
            light.a += 1.0;
    } while (++i < uRayCount);
    light.a *= sunThroughSmoke(origin) / float(uRayCount);
}
