// Mean radiance from the sky and from what hides it, over the cosine-weighted hemisphere, in the colour of `light`.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/sky.glsl"
#include "lib/bounce.glsl"

uniform int uRays;
uniform float uReach;  // metres

in vec2 uv;
out vec4 light;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    light = vec4(0.0);
    if (s.sky) return;
    vec3 origin = shadowOrigin(worldFromDepth(uv, s.depth), s.normal);
    for (int i = 0; i < uRays; ++i) {
        vec3 direction = cosineDirection(s.normal, blueNoise(pixel, 1, frame.counters.x * uRays + i));
        float t;
        if (shadowTrace(origin, direction, uReach, t))
            light.rgb += bounceRadiance(origin + direction * t, direction);
        else
            light.rgb += skyRadiance(direction);
    }
    light.rgb /= float(uRays);
}
