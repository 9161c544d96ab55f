// Reflections of smooth surfaces and glass: one mirror ray a pixel. The reflected radiance is the integral of L times
// the specular lobe. Its direction is drawn by reflecting the view about a visible GGX normal (lib/sampling.glsl),
// whose density is nearly the lobe itself, so that the sample is just the radiance of the ray. rgb radiance, a metres
// to the hit. Passes "reflection_accumulate" and "reflection_filter" take away the noise.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"
#include "lib/fog.glsl"
#include "lib/bounce.glsl"
#include "lib/mirror.glsl"

uniform sampler2D uLight;

in vec2 uv;
out vec4 reflection;

const float kMaxRayDistance = 1e5;  // metres: to the edge of the level, beyond which there is nothing to meet
const float kSkyMetres = 1000.0;    // of what is farther the image hardly moves
const float kMinRoughness = 0.03;   // smoother surfaces mirror as if they were ideal

/// Radiance of a mirror ray, without the sun's disc: the analytic highlight has that, and without noise.
vec3 mirrored(vec3 origin, vec3 direction, PathStart start, float emissionWeight, out float t) {
    if (!shadowTrace(origin, direction, kMaxRayDistance, t))
        return throughOpenFog(mirroredBackground(origin, direction), origin, direction, uSunUp);
    vec3 radiance = mix(radianceAt(origin + direction * t, direction, start, emissionWeight), hazeRadiance(direction),
                        hazeAmount(t));
    return throughFog(radiance, origin, direction, t, start.light, false);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Mirror m = mirrorAt(pixel, uv);
    vec3 halfVector = m.normal;
    if (m.roughness > kMinRoughness) {
        mat3 basis = orthonormalBasis(m.normal);
        halfVector = basis * sampleVisibleNormal(m.view * basis, m.roughness * m.roughness,
                                                 blueNoise(pixel, 20, frame.counters.x));
    }
    vec3 direction = reflect(-m.view, halfVector);
    direction += m.normal * max(0.0, 0.02 - dot(direction, m.normal));
    vec3 more = vec3(blueNoise(pixel, 21, frame.counters.x, kR5Steps.xy),
                     blueNoise(pixel, 22, frame.counters.x, kR5Steps.zw).x);
    PathStart start = startPath(texelFetch(uLight, pixel, 0).rgb, m.normal,
                                uBounceLights ? lightsAt(pixel, viewDepth(m.position)) : ivec2(0));
    start.random = more;
    float t;
    vec3 radiance = mirrored(surfaceOrigin(m.position, m.normal, m.fine), normalize(direction), start,
                             1.0 - analyticHighlightShare(m.roughness), t);
    reflection = vec4(halfRange(radiance), clamp(t, 0.01, kSkyMetres));
}
