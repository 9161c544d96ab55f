// Direct light of local lights with one shadow ray a pixel, or some where history was just dropped
// (lib/change_rays.glsl). lib/local_lights.glsl derives how one light is chosen.
//
// The ray's direction serves the diffuse light and the highlight, and they want different densities: the diffuse light
// that of the light's solid angle (p_light), the highlight that of the BRDF's lobe (p_lobe). So with the probability q
// the direction is drawn from the lobe, else from the light; either way its density is
//   p = (1 - q) p_light + q p_lobe
// and the sample counts f L cos / p: one-sample multiple importance sampling with the balance heuristic (Veach and
// Guibas 1995). It is unbiased for any q; lobeProbability() chooses q by how much the highlight matters.
// Light too faint to be worth a ray in each frame is sampled by Russian roulette (Arvo and Kirk 1990).
// Irradiance / pi is added to the colour of `light`; the highlight is averaged over time in `specular`.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/surface_history.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/moving_bodies.glsl"
#include "lib/brdf.glsl"
#include "lib/local_lights.glsl"
#include "lib/history_left.glsl"

uniform sampler2D uSpecularHistory;
uniform sampler2D uSurfaceHistory;  // x linear depth, z frames accumulated
uniform bool uHistoryValid;
uniform float uMaxHighlightHistory;  // frames
uniform int uLightChangeCount;
// By turns: xyz where a light has changed, w its reach; x how many frames are remembered there.
uniform vec4 uLightChange[2 * kMaxLightChanges];
uniform bool uHasReflections;    // mirror rays are traced too
uniform float uFullRayRadiance;  // radiance of a white surface below which Russian roulette begins

in vec2 uv;
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 specular;  // rgb radiance of the highlight, a luminance of the light that arrives

const float kMaxHistoryInMotion = 16.0;  // frames
const float kMaxSpecular = 1000.0;       // of a highlight's sample

/// Draws one of the lights near a pixel. Returns 1 / its probability, or 0 if no ray is to be sent.
float sampleLight(ivec2 cell, vec3 position, vec3 normal, vec2 random, out int light) {
    Reservoir reservoir = chooseLight(cell, position, normal, random);
    light = max(reservoir.light, 0);
    float chance = min(reservoir.weightSum / (kPi * uFullRayRadiance), 1.0);
    return reservoir.random < chance && reservoir.weightSum > 0.0 ? reservoir.weightSum / (reservoir.weight * chance)
                                                                  : 0.0;
}

/// Probability q of a direction from the lobe: the highlight's share of what the pixel shows of this light, as the
/// diffuse light loses samples by it. 0 where the lobe hardly varies over the light, for there p_light does as well.
float lobeProbability(LocalLight localLight, vec3 toCentre, Surface s, vec3 view, vec3 f0) {
    float extent = isRectangle(localLight) ? localLight.extent : localLight.radius;
    float subtended = hemisphereFraction(extent, max(dot(toCentre, toCentre), 1e-6));
    // The lobe is densest toward the light's point nearest to the mirrored ray (Karis 2013, the representative point).
    vec3 mirrored = reflect(-view, s.normal), aside = mirrored * max(dot(toCentre, mirrored), 1e-3) - toCentre;
    vec3 nearest = normalize(toCentre + aside * min(extent * inversesqrt(max(dot(aside, aside), 1e-12)), 1.0));
    float densityRatio = ggxVndfPdf(s.normal, view, nearest, s.roughness) * 2.0 * kPi * subtended;  // p_lobe / p_light
    float highlight = luminance(fresnel(f0, dot(view, s.normal))) * (1.0 - 2.0 / max(densityRatio, 2.0)) *
                      (uHasReflections ? analyticHighlightShare(s.roughness) : 1.0);
    // A diffuse surface of albedo one half shows the light's radiance times `subtended`.
    return min(highlight / (highlight + subtended), 0.75);
}

/// How many frames the highlights of a place are averaged over.
float maxHistoryAt(vec3 position) {
    float maxFrames = uMaxHighlightHistory;
    int i = loopBegin();
    do {
        if (uLightChangeCount == 0) break;
        if (distance(position, uLightChange[i].xyz) < uLightChange[i].w)
            maxFrames = min(maxFrames, uLightChange[i + 1].x);
    } while ((i += 2) < uLightChangeCount);
    return maxFrames;
}

/// This frame's highlight of so many rays, averaged with the history of the same place.
vec4 accumulateSpecular(vec4 now, vec3 position, Surface s, float rays) {
    vec2 motion = texelFetch(uMotion, ivec2(gl_FragCoord.xy), 0).rg, lastUv = uv - motion;
    if (!uHistoryValid || any(lessThan(lastUv, vec2(0.0))) || any(greaterThanEqual(lastUv, vec2(1.0)))) return now;
    ivec2 last = ivec2(lastUv * frame.targetSize.xy);
    vec4 surface = texelFetch(uSurfaceHistory, last, 0);
    float expected = previousDepth(position);
    float tolerance = depthTolerance(position, s.normal, s.depth) + s.moving * 0.5;
    if (abs(surface.x - expected) > tolerance || dot(unpackNormal(surface.y), s.normal) < 0.9) return now;
    // A highlight moves over its surface as the camera does: it may lag by an eighth of the lobe.
    float turn = distance(toEye(position), normalize(previousEyeOf(position) - position));
    float maxFrames = min(maxHistoryAt(position), max(0.25 * ggxAlpha(s.roughness) / max(turn, 1e-6), 1.0));
    if (length(motion * frame.targetSize.xy) >= 0.05) maxFrames = min(maxFrames, kMaxHistoryInMotion);
    return mix(texelFetch(uSpecularHistory, last, 0), now,
               rays / clamp(floor(surface.z) + rays, rays, maxFrames * rays));
}

/// A pixel and its surface, as its rays see them.
struct Receiver {
    ivec2 pixel;
    Surface surface;
    vec3 position, view, f0;
    ivec2 lights;  // lightsAt()
    vec3 origin;   // of its rays
};

/// One ray to one of the lights. Adds its light and highlight.
void addSample(Receiver r, int n, inout vec4 light, inout vec4 specular) {
    int chosen;
    float sampleWeight =
        sampleLight(r.lights, r.position, r.surface.normal, blueNoise(r.pixel, 2, n, kR5Steps.xy), chosen);
    LocalLight localLight = readLight(chosen);
    vec2 random = blueNoise(r.pixel, 3, n), more = blueNoise(r.pixel, 4, n, kR5Steps.zw);
    vec3 normal = r.surface.normal, toCentre = toLight(localLight, r.position, more.x);
    float roughness = r.surface.roughness, lobeChance = lobeProbability(localLight, toCentre, r.surface, r.view, r.f0);
    bool byLobe = more.y < lobeChance;
    mat3 basis = orthonormalBasis(normal);
    vec3 mirrored = reflect(-r.view, basis * sampleVisibleNormal(r.view * basis, ggxAlpha(roughness), random));
    SphericalRectangle face = rectangleOf(localLight, toCentre);
    vec3 direction = byLobe ? mirrored : sampleLightDirection(localLight, toCentre, face, random);
    LightSample point = evaluateLight(localLight, toCentre, face, direction, !byLobe);
    float pdf = mix(point.pdf, ggxVndfPdf(normal, r.view, direction, roughness), lobeChance);
    vec3 arriving = point.radiance * (max(dot(direction, normal), 0.0) * sampleWeight / (kPi * pdf));
    bool dark = luminance(arriving) <= 0.0;
    vec3 origin = r.origin, shadowRay = r.position + direction * point.range - origin;
    float shadowRayLength = max(length(shadowRay), 1e-4), t;
    // Where nothing would arrive the ray has no length, and costs little.
    float tMax = dark ? -1.0 : max(shadowRayLength - point.clearance, 0.0);
    if (shadowTrace(origin, shadowRay / shadowRayLength, tMax, t) || dark) return;
    arriving = halfRange(arriving);
    light.rgb += arriving;
    vec3 mirroredShare =
        fresnel(r.f0, dot(r.view, normalize(r.view + direction))) * specularLobe(normal, r.view, direction, roughness);
    specular += vec4(min(mirroredShare * arriving * kPi, vec3(kMaxSpecular)), luminance(arriving));
}

/// Rays of a pixel in this frame.
int raysOf(ivec2 pixel) {
    vec2 lastUv = uv - texelFetch(uMotion, pixel, 0).rg;
    bool known = uHistoryValid && lastUv == clamp(lastUv, vec2(0.0), vec2(0.999));
    return known ? historyLeftOf(ivec2(lastUv * frame.targetSize.xy)).rays : 1;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    // local_lights.vert skips such tiles, but compute programs draw no quads.
    if (lightsAt(pixel, -1.0).y == 0) discard;
    Surface s = readSurface(pixel);
    if (!s.lit) discard;
    vec3 position = worldFromDepth(uv, s.depth);
    Receiver receiver = Receiver(pixel, s, position, toEye(position),
                                 mix(vec3(s.reflectivity), s.albedo, s.metallic), lightsAt(pixel, s.depth),
                                 surfaceOrigin(placeInShadows(position, s.normal, s.moving), s.normal, s.fine));
    light = specular = vec4(0.0);
    int rays = raysOf(pixel), i = 0;
    do {
        addSample(receiver, frame.counters.x * rays + i, light, specular);
    } while (++i < rays);
    light /= float(rays), specular /= float(rays);
    specular = accumulateSpecular(specular, position, s, float(rays));
}
