// In-scattering of fog: the mean radiance that the fog in front of each pixel sends to the camera, at half resolution,
// with two shadow rays a pixel and averaged over time. The single-scattering integral along a ray is
//   L = integral_0^end  s(t) T(t) [sum over lights of phase L_i(t)] dt,   T = exp(-tau(t))
// passes/fog.frag multiplies the mean of the bracket by the share 1 - T(end) of light that the fog takes. So a distance
// t is drawn in proportion to s T (the inverse of tau, lib/fog.glsl), and the sample is just phase times light; the sky
// is sampled evenly, as if scattering were isotropic. Local lights vary as 1 / d^2 along the ray, so for them t is
// drawn equi-angularly: with D the light's distance from the ray and t measured from the nearest point, t = D
// tan(angle), angle uniform between those of both ends, the density is p(t) = D / ((angle_b - angle_a) (D^2 + t^2)),
// which cancels 1 / d^2 (Kulla and Fajardo 2012). One ray goes to the sun, one to a local light or the sky, chosen by
// weighted reservoir sampling.
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/half.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/sky.glsl"
#include "lib/fog.glsl"
#include "lib/local_lights.glsl"

uniform sampler2D uDepth;
uniform sampler2D uHistory;  // rgb mean light, a frames
uniform bool uHistoryValid;
uniform bool uSunUp;
uniform bool uHasLocalLights;
uniform float uMaxHistory;  // frames; fewer count where the image moves

in vec2 uv;
out vec4 light;

const float kGoldenStep = 0.6180339887;
const float kMaxHistoryInMotion = 12.0;                      // frames
const float kSunRayDistance = 80.0, kSkyRayDistance = 16.0;  // metres

struct FogRay {
    vec3 start, direction;
    float end;    // metres
    float share;  // of light that its fog takes: 1 - T(end)
};

/// A distance with a density in proportion to s T.
float sampleFogDistance(FogRay ray, float u) {
    return min(fogDistance(ray.start.y, ray.direction.y, -log(1.0 - u * ray.share)), ray.end);
}

vec3 sunInscatter(FogRay ray, float u) {
    vec3 place = ray.start + ray.direction * sampleFogDistance(ray, u);
    float t;
    if (!uSunUp || shadowTrace(place, frame.sunDirection.xyz, kSunRayDistance, t)) return vec3(0.0);
    float above = fogDensity(place.y) * frame.fog.z / max(frame.sunDirection.y, 0.05);
    return frame.sunColor.rgb * (henyeyGreenstein(dot(ray.direction, frame.sunDirection.xyz)) * exp(-above));
}

/// The part of a ray within a light's reach, as angles seen from the light.
struct LightSegment {
    float nearest;   // the ray's point nearest to the light, metres along it
    float aside;     // D: distance of the light from there
    float from, to;  // angles of both ends, radians
};
LightSegment lightSegment(FogRay ray, vec3 place, float reach) {
    vec3 toCentre = place - ray.start;
    float along = dot(toCentre, ray.direction), aside2 = max(dot(toCentre, toCentre) - along * along, 0.0);
    float halfChord = sqrt(max(reach * reach - aside2, 0.0)), aside = max(sqrt(aside2), 0.1);
    float first = max(along - halfChord, 0.0), last = min(along + halfChord, ray.end);
    if (last <= first) return LightSegment(along, aside, 0.0, 0.0);
    return LightSegment(along, aside, atan(first - along, aside), atan(last - along, aside));
}

/// A place in the fog, the shadow ray from there, and the in-scattered light if nothing blocks it.
struct FogSample {
    vec3 place, direction;
    float range;
    vec3 light;
};

FogSample sampleTowardLight(FogRay ray, LocalLight light, vec2 u) {
    LightSegment p = lightSegment(ray, light.position, light.reach + light.extent);
    float beyond = p.aside * tan(mix(p.from, p.to, u.x)), metres = p.nearest + beyond;
    vec3 place = ray.start + ray.direction * metres;
    vec3 up = cross(light.right, light.axis);
    vec3 fromMiddle = place - light.position;
    // As if all light came from the light's nearest point.
    vec2 limit = light.kind == kSphere ? vec2(0.0) : light.halfSize;
    vec2 on = clamp(vec2(dot(fromMiddle, light.right), dot(fromMiddle, up)), -limit, limit);
    vec3 toLight = on.x * light.right + on.y * up - fromMiddle;
    float range = max(length(toLight), 1e-3);
    toLight /= range;
    float cosine = -dot(toLight, light.axis);
    float edge = light.kind < kArea ? coneAttenuation(light, cosine) : light.twoSided ? abs(cosine) : max(cosine, 0.0);
    float strength = edge * lightWindow(range, light.reach) * henyeyGreenstein(dot(ray.direction, toLight)) *
                     (p.to - p.from) / p.aside;
    float fog = fogDensity(place.y);
    strength *= fog * exp(-fogOpticalDepth(ray.start.y, ray.direction.y, metres) - fog * range) / ray.share;
    return FogSample(place, toLight, max(range - max(light.radius, 0.12), 0.0), light.color * strength);
}

FogSample sampleTowardSky(FogRay ray, vec3 u) {
    vec3 direction = uniformSphere(u.xy);
    return FogSample(ray.start + ray.direction * sampleFogDistance(ray, u.z), direction, kSkyRayDistance,
                     skyRadiance(direction));
}

/// The weight of a candidate: about the luminance of a light's in-scattering without shadows.
float unshadowedFogRadiance(FogRay ray, int i) {
    i *= kTexelsPerLight;
    vec4 a = fetch4f(uLights, i), c = fetch4f(uLights, i + 2);
    vec3 toCentre = a.xyz - ray.start;
    float along = dot(toCentre, ray.direction), aside2 = max(dot(toCentre, toCentre) - along * along, 0.01),
          reach = c.y + a.w;
    float halfChord = sqrt(max(reach * reach - aside2, 0.0)), first = max(-halfChord, -along),
          last = min(halfChord, ray.end - along), aside = sqrt(aside2);
    // The angle between both ends, as the light sees it.
    float angle = last > first ? atan(aside * (last - first), aside2 + first * last) : 0.0;
    return c.x * angle / aside * fogDensity(ray.start.y + ray.direction.y * max(along, 0.0)) * 0.08 /
           ray.share;
}

/// In-scattering of local lights and sky, estimated with one of them.
vec3 otherInscatter(FogRay ray, ivec2 pixel, vec2 random, vec3 u) {
    float sky = luminance(mix(frame.skyColor.rgb, frame.horizonColor.rgb, 0.5)) * 0.5 + 1e-5;
    Reservoir reservoir = Reservoir(-1, sky, sky, random.x);
    ivec2 cell = uHasLocalLights ? lightsAt(pixel, -1.0) : ivec2(0);
    int candidates = candidateCount(cell.y);
    int i = 0;
    do {
        if (candidates == 0) break;
        vec2 next = candidateLight(cell, i, random.y);
        updateReservoir(reservoir, int(next.x), unshadowedFogRadiance(ray, int(next.x)), next.y);
    } while (++i < candidates);
    // One call, as lanes of a GPU would run two one after the other.
    bool isSky = reservoir.light < 0;
    FogSample chosen;  // WebGL has no ?: for structs
    if (isSky)
        chosen = sampleTowardSky(ray, u);
    else
        chosen = sampleTowardLight(ray, readLight(reservoir.light), u.xy);
    float t;
    bool dark = luminance(chosen.light) <= 0.0;
    if (shadowTrace(chosen.place, chosen.direction, dark ? -1.0 : chosen.range, t)) return vec3(0.0);
    return chosen.light * (reservoir.weightSum / reservoir.weight);
}

void main() {
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * 2, ivec2(frame.targetSize.xy) - 1);
    vec2 pixelUv = (vec2(pixel) + 0.5) * frame.targetSize.zw;
    vec3 toPixel = viewRay(pixelUv);
    float stretch = length(toPixel);
    FogRay ray;
    ray.start = viewOrigin(pixelUv);
    ray.direction = toPixel / stretch;
    ray.end = min(texelFetch(uDepth, pixel, 0).r * stretch, kMaxFogDistance);
    ray.share = max(1.0 - exp(-fogOpticalDepth(ray.start.y, ray.direction.y, ray.end)), 1e-5);
    ivec2 halfPixel = ivec2(gl_FragCoord.xy);
    int n = frame.counters.x;
    vec2 u = blueNoise(halfPixel, 30, n, kR5Steps.xy), v = blueNoise(halfPixel, 31, n, kR5Steps.zw),
         w = blueNoise(halfPixel, 32, n, vec2(kR5LastStep, kGoldenStep));
    vec3 now = sunInscatter(ray, w.y) + otherInscatter(ray, pixel, v, vec3(u, w.x));
    light = vec4(min(now, vec3(1000.0)), 1.0);

    vec3 middle = ray.start + ray.direction * sampleFogDistance(ray, 0.5);
    vec4 clip = frame.previousViewProjection * vec4(middle, 1.0);
    vec2 lastUv = clip.xy / max(clip.w, 1e-3) * 0.5 + 0.5;
    if (!uHistoryValid || previousDepth(middle) < 0.05 || lastUv != clamp(lastUv, vec2(0.0), vec2(1.0))) return;
    // What stands still on the screen keeps its own texel, so that noise does not run into blotches.
    bool isStill = length((lastUv - pixelUv - frame.jitter.xy) * frame.targetSize.xy) < 0.05;
    vec4 last = isStill ? texelFetch(uHistory, halfPixel, 0) : texture(uHistory, lastUv);
    float frames = min(last.a + 1.0, isStill ? uMaxHistory : min(uMaxHistory, kMaxHistoryInMotion));
    light = stochasticRoundToHalf(vec4(mix(last.rgb, light.rgb, 1.0 / frames), 0.0), halfPixel, 9);
    light.a = frames;
}
