// How direct light has changed since the previous frame because lights are others: another colour, on or out, moved.
// Temporal accumulation adds it to the history of light, so that this holds for the lights of now. Light is linear in
// the lights: what has changed at a place is what lights send that have the difference as their colour
// (render/scene/light_grid.cpp), a negative one for what is sent less. Each is sampled as in passes/local_lights.frag,
// with kRays shadow rays. Out of penumbras they agree, so that the change is nearly without noise, where the light
// itself is a mean of many frames. Indirect light follows through the history confidence.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/moving_bodies.glsl"
#include "lib/local_lights.glsl"

uniform int uFirstDifference;  // of uLights
uniform int uDifferenceCount;
uniform float uMinRadiance;  // of a white surface

in vec2 uv;
out vec4 change;  // rgb irradiance / pi

const int kRays = 2;

/// One ray to one of the lights.
vec3 sampleDifference(LocalLight light, vec3 position, vec3 normal, vec3 origin, vec2 random, float more) {
    vec3 toCentre = toLight(light, position, more);
    SphericalRectangle face = rectangleOf(light, toCentre);
    vec3 direction = sampleLightDirection(light, toCentre, face, random);
    LightSample point = evaluateLight(light, toCentre, face, direction, true);
    vec3 arriving = point.radiance * (max(dot(direction, normal), 0.0) / (kPi * point.pdf));
    vec3 shadowRay = position + direction * point.range - origin;
    float shadowRayLength = max(length(shadowRay), 1e-4), t;
    bool dark = arriving == vec3(0.0);
    float tMax = dark ? -1.0 : max(shadowRayLength - point.clearance, 0.0);
    return shadowTrace(origin, shadowRay / shadowRayLength, tMax, t) || dark ? vec3(0.0) : arriving;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    change = vec4(0.0);
    Surface s = readSurface(pixel);
    if (!s.lit) return;
    vec3 position = worldFromDepth(uv, s.depth);
    vec3 origin = surfaceOrigin(placeInShadows(position, s.normal, s.moving), s.normal, s.fine);
    int i = loopBegin();
    do {
        if (i >= uDifferenceCount * kRays) break;
        int number = uFirstDifference + i / kRays, n = frame.counters.x * kRays + i % kRays;
        if (unshadowedIrradiance(number, position, s.normal) < kPi * uMinRadiance) continue;
        change.rgb += sampleDifference(readLight(number), position, s.normal, origin, blueNoise(pixel, 3, n),
                                       blueNoise(pixel, 4, n).x) / float(kRays);
    } while (++i < uDifferenceCount * kRays);
}
