// Indirect light from sky and surfaces: irradiance / pi, the mean radiance over the cosine-weighted hemisphere.
//   E / pi = integral L(d) cos / pi dd  ~  1 / n sum L(d_i),   d_i drawn with the density cos / pi
// Rays that leave see the sky; rays that hit bring the radiance of lib/bounce.glsl. `hitProximity` is the mean of
// 1 / (1 + t / 1 m) over the rays, with 0 for those that leave: an ambient obscurance (Zhukov et al. 1998) which guides
// the filter and says how much a place is enclosed.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/moving_bodies.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"
#include "lib/glass_shadow.glsl"
#define HAS_GLASS_SHADOW
#include "lib/bounce.glsl"

uniform int uRayCount;
uniform float uExactDistance;  // metres
uniform sampler2D uLightHistory;

in vec2 uv;
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 hitProximity;  // x: 1 where rays hit at once, 0 where they leave

const int kBouncesAfterChange = 2;         // more than usual
const float kHalfProximityDistance = 1.0;  // metres: a hit at this distance counts a half

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    light = hitProximity = vec4(0.0);
    if (!s.lit) return;
    vec3 place = placeInShadows(worldFromDepth(uv, s.depth), s.normal, s.moving);
    vec3 origin = surfaceOrigin(place, s.normal, s.fine);
    vec2 lastUv = uv - texelFetch(uMotion, pixel, 0).rg;
    bool known = uHistoryValid && lastUv == clamp(lastUv, vec2(0.0), vec2(0.999));
    ivec2 last = ivec2(lastUv * frame.targetSize.xy);
    PathStart start = startPath(vec3(0.0), s.normal, uBounceLights ? lightsAt(pixel, s.depth) : ivec2(0));
    int rays = uRayCount;
    if (known) {
        start.light = texelFetch(uLightHistory, last, 0).rgb;
        HistoryLeft left = historyLeftOf(last);
        start.light *= countsOfPreviousFrame(left.now * uMaxHistory);
        start.hitProximity = fract(texelFetch(uSurfaceHistory, last, 0).z);
        rays = max(rays, left.rays);
        // The previous frame's light stands for no further bounces, which matter where light comes from all around.
        bool isEnclosed = start.hitProximity > 0.5 * (kIndoorProximity.x + kIndoorProximity.y);
        if (isEnclosed && countsOfPreviousFrame(left.now * uMaxHistory) < 1.0) start.maxBounces += kBouncesAfterChange;
    }
    int i = 0;
    do {
        int n = frame.counters.x * rays + i;
        vec3 direction = cosineDirection(s.normal, blueNoise(pixel, 1, n));
        start.directionSample = blueNoise(pixel, 7, n, kR5Steps.xy);
        start.random = vec3(blueNoise(pixel, 5, n, kR5Steps.zw), blueNoise(pixel, 6, n, vec2(kR5LastStep)).x);
        float t;
        if (shadowTraceCoarse(origin, direction, uMaxDistance, uExactDistance, t)) {
            if (known) start.maxEmission = maxEmission(start.light, t);
            light.rgb += radianceAt(origin + direction * t, direction, start, 0.0);
            hitProximity.x += kHalfProximityDistance / (kHalfProximityDistance + t);
        } else {
            light.rgb += skyRadiance(direction);
        }
    } while (++i < rays);
    light.rgb /= float(rays);
    light.rgb = halfRange(light.rgb);
    hitProximity.x /= float(rays);
}
