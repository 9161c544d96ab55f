// Light of spheres, capsules, cones, areas and screens: one ray to a random point of one light, chosen in proportion to what each
// would send here without shadows (resampling, Talbot et al. 2005): right on average, at one price whatever their number.
// Irradiance / pi is added to the colour of `light`; what shines back to the eye is averaged over time in `specular`.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/surface_history.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/brdf.glsl"
#include "lib/local_lights.glsl"

uniform sampler2D uSpecularHistory;
uniform sampler2D uSurfaceHistory;   // x linear depth, z frames accumulated
uniform bool uHistoryValid;
uniform float uMaxHistory;           // frames
uniform int uLightChangeCount;
uniform vec4 uLightChange[32];         // by turns: xyz where a light has come or gone out, w how far it reaches; x frames that are remembered there
uniform bool uHasReflections;        // mirror rays are sent too
uniform float uFullRayRadiance;          // radiance of a white surface below which rays are sent only now and then

in vec2 uv;
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 specular;  // rgb radiance, a luminance of the light that came in

const float kLongestInMotion = 16.0;  // frames
const float kBrightest = 1000.0;  // of a highlight's sample: a last guard

/// One of the lights near a pixel, and by what its sample is to be multiplied: 0 for none.
float drawLight(ivec2 cell, vec3 position, vec3 normal, vec2 random, out int light) {
    Choice choice = chooseLight(cell, position, normal, random);
    light = max(choice.light, 0);
    // Faint light is looked for now and then, and counts for more.
    float chance = min(choice.total / (kPi * uFullRayRadiance), 1.0);
    return choice.random < chance && choice.total > 0.0 ? choice.total / (choice.weight * chance) : 0.0;
}

/// How often a direction of the lobe is asked instead of a point of the lamp: by how much of the highlight is shown against the diffuse
/// light, which loses samples by it. Never where the lobe hardly changes over the lamp.
float lobeShare(LocalLight lamp, vec3 toPlace, Surface s, vec3 view, vec3 f0) {
    float extent = lamp.kind >= kArea ? lamp.extent : lamp.radius;
    float opening = openingOf(extent, max(dot(toPlace, toPlace), 1e-6));
    // Where the lobe is densest: to the point nearest to the mirrored ray (Karis 2013, "Real Shading in Unreal Engine 4").
    vec3 mirrored = reflect(-view, s.normal), aside = mirrored * max(dot(toPlace, mirrored), 1e-3) - toPlace;
    vec3 nearest = normalize(toPlace + aside * min(extent * inversesqrt(max(dot(aside, aside), 1e-12)), 1.0));
    float denser = lobeDensity(s.normal, view, nearest, s.roughness) * 2.0 * kPi * opening;  // than samples of the lamp
    float highlight = luminance(fresnel(f0, dot(view, s.normal))) * (1.0 - 2.0 / max(denser, 2.0)) * (uHasReflections ? lampsByLobe(s.roughness) : 1.0);
    return min(highlight / (highlight + opening), 0.75);  // a surface that scatters half gives the lamp's radiance times `opening`
}

/// Frames that highlights of a place are averaged over.
float longestAt(vec3 position) {
    float longest = uMaxHistory;
    for (int i = 0; i < uLightChangeCount; i += 2)
        if (distance(position, uLightChange[i].xyz) < uLightChange[i].w) longest = min(longest, uLightChange[i + 1].x);
    return longest;
}

/// This frame's highlight, averaged with those of the same place in the frames before.
vec4 overTime(vec4 now, vec3 position, Surface s) {
    vec2 motion = texelFetch(uMotion, ivec2(gl_FragCoord.xy), 0).rg, lastUv = uv - motion;
    if (!uHistoryValid || any(lessThan(lastUv, vec2(0.0))) || any(greaterThanEqual(lastUv, vec2(1.0)))) return now;
    ivec2 last = ivec2(lastUv * frame.targetSize.xy);
    vec4 surface = texelFetch(uSurfaceHistory, last, 0);
    float expected = (frame.previousViewProjection * vec4(position, 1.0)).w;
    float tolerance = depthTolerance(position, s.normal, s.depth) + s.moving * 0.5;
    if (abs(surface.x - expected) > tolerance || dot(unpackNormal(surface.y), s.normal) < 0.9) return now;
    // A highlight moves over its surface as soon as the eye does.
    float longest = length(motion * frame.targetSize.xy) < 0.05 ? longestAt(position) : min(longestAt(position), kLongestInMotion);
    return mix(texelFetch(uSpecularHistory, last, 0), now, 1.0 / clamp(floor(surface.z) + 1.0, 1.0, longest));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (lightsAt(pixel, -1.0).y == 0) discard;  // local_lights.vert leaves these tiles out; compute has none
    Surface s = readSurface(pixel);
    vec3 position = worldFromDepth(uv, s.depth);
    int chosen;
    float share = drawLight(lightsAt(pixel, s.depth), position, s.normal, blueNoise(pixel, 2, frame.counters.x), chosen);
    LocalLight lamp = readLight(chosen);
    vec2 random = blueNoise(pixel, 3, frame.counters.x), more = blueNoise(pixel, 4, frame.counters.x);
    vec3 view = normalize(frame.cameraPosition.xyz - position), toPlace = toLight(lamp, position, more.x);
    vec3 f0 = mix(vec3(s.reflectivity), s.albedo, s.metallic);
    float lobes = lobeShare(lamp, toPlace, s, view, f0);
    bool byLobe = more.y < lobes;
    mat3 basis = basisAround(s.normal);
    vec3 mirrored = reflect(-view, basis * visibleHalfVector(view * basis, lobeAlpha(s.roughness), random));
    vec3 direction = byLobe ? mirrored : directionTo(lamp, toPlace, random);
    LightSample point = lightAlong(lamp, toPlace, direction, !byLobe);
    float density = mix(point.density, lobeDensity(s.normal, view, direction, s.roughness), lobes);
    vec3 arriving = point.radiance * (max(dot(direction, s.normal), 0.0) * share / (kPi * density));
    bool dark = luminance(arriving) <= 0.0;
    vec3 origin = shadowOrigin(position, s.normal), way = position + direction * point.range - origin;
    float wayLength = max(length(way), 1e-4), t;
    light = specular = vec4(0.0);
    // Where nothing would arrive the ray has no length.
    if (!shadowTrace(origin, way / wayLength, dark ? -1.0 : max(wayLength - point.own, 0.0), t) && !dark) {
        light.rgb = arriving;
        vec3 mirroredShare = fresnel(f0, dot(view, normalize(view + direction))) * specularLobe(s.normal, view, direction, s.roughness);
        specular = vec4(min(mirroredShare * arriving * kPi, vec3(kBrightest)), luminance(arriving));
    }
    specular = overTime(specular, position, s);
}
