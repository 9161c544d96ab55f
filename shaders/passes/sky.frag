// Mean radiance from the sky and from what hides it, over the cosine-weighted hemisphere, in the colour of `light`; how near that is, in `nearness`.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"
#include "lib/bounce.glsl"

uniform int uRays;
uniform float uExactFor;  // metres
uniform sampler2D uLastLight;

in vec2 uv;
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 nearness;  // x: 1 where rays meet something at once, 0 where nothing

const float kNear = 1.0;  // metres at which it is a half

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    light = nearness = vec4(0.0);
    if (s.sky) return;
    vec3 origin = shadowOrigin(worldFromDepth(uv, s.depth), s.normal);
    vec2 lastUv = uv - texelFetch(uMotion, pixel, 0).rg;
    bool known = uLastValid && lastUv == clamp(lastUv, vec2(0.0), vec2(0.999));
    ivec2 last = ivec2(lastUv * frame.targetSize.xy);
    Here here = startingAt(vec3(0.0), s.normal, uLamps ? lightsAt(pixel, s.depth) : ivec2(0));
    if (known) here.light = texelFetch(uLastLight, last, 0).rgb, here.nearness = fract(texelFetch(uLastSurface, last, 0).z);
    for (int i = 0; i < uRays; ++i) {
        vec3 direction = cosineDirection(s.normal, blueNoise(pixel, 1, frame.counters.x * uRays + i));
        here.random = vec3(blueNoise(pixel, 5, frame.counters.x * uRays + i), blueNoise(pixel, 6, frame.counters.x * uRays + i).x);
        here.way = blueNoise(pixel, 7, frame.counters.x * uRays + i);
        float t;
        if (shadowTraceCoarse(origin, direction, uReach, uExactFor, t)) {
            light.rgb += radianceAt(origin + direction * t, direction, here, 0.0);
            nearness.x += kNear / (kNear + t);
        } else {
            light.rgb += skyRadiance(direction);
        }
    }
    light.rgb /= float(uRays);
    nearness.x /= float(uRays);
}
