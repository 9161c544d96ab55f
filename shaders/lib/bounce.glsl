// What a ray sees where it meets the world: the lit colour if the last picture shows that position, else its voxel's emitted colour in the
// light of sun, sky and lamps. Needs lib/frame, gbuffer, sky, shadow_trace, sampling, brdf.
#include "lib/surface_history.glsl"
#include "shared/constants.h"
#include "lib/color.glsl"
#include "lib/local_lights.glsl"
#include "lib/voxel_walk.glsl"
#include "lib/paint.glsl"
#include "lib/voxel_at.glsl"
uniform sampler2D uRadianceHistory;  // last frame's picture before post-processing
uniform sampler2D uSurfaceHistory;   // lib/surface_history.glsl
uniform sampler2D uDiffuseFractionHistory;     // composite.frag
uniform bool uHistoryValid;
uniform bool uDiffuseOnly;  // what is onScreen shines alike to all sides: highlights are the eye's alone
uniform bool uSunUp;
uniform bool uBounce;
uniform int uMaxBounces;  // faces that no picture shows, at most: the rest of the light is guessed at the last one
uniform float uMaxDistance;  // metres that rays see which go on
uniform bool uBounceLights;  // specular where no picture shows it

const float kScreenEdgeFade = 0.15;         // of the picture's half width and height: how far the trust in it takes to grow
const float kDefaultAlbedo = 0.3; // where no voxel is found
// Close to a localLight few rays would speckle: as bright, or as many times as bright as where the ray started, where more of it is no surprise.
const float kMaxLightRadiance = 6.0, kMaxLightRadianceRatio = 150.0;
const float kMaxOpennessRatio = 1.4;
const vec2 kIndoorProximity = vec2(0.1, 0.3);  // hitProximity from which light comes from all around as well as from above
const float kMaxReflectance = 0.95;     // back of the light that comes in: what a white room guesses of its emitted light never grows
const vec2 kR2Step = vec2(0.7548776662, 0.5698402910);  // R2, as lib/noise

/// The cell face that a ray has come through at a point on the shadow volume's cells.
vec3 faceNormal(vec3 hitWorld, vec3 direction) {
    vec3 fromEdge = abs(fract(hitWorld / kShadowCell + 0.5) - 0.5);
    // An axis along which the ray hardly moves cannot have been entered.
    fromEdge += 1.0 - step(0.02, abs(direction));
    if (fromEdge.x <= fromEdge.y && fromEdge.x <= fromEdge.z) return vec3(-sign(direction.x), 0, 0);
    if (fromEdge.y <= fromEdge.z) return vec3(0, -sign(direction.y), 0);
    return vec3(0, 0, -sign(direction.z));
}

/// normal: of the face that was hit. What the picture shows there must face the same shadowRay: the far side of a thin wall is another position.
/// glow: the throughput that counts of voxels that specular: what the rays to their localLight bring must not come a second time.
/// a: 0 where it is not shown, 1 where it is, less toward the picture's edge.
vec4 radianceOnScreen(vec3 hitWorld, vec3 normal, float glow) {
    if (!uHistoryValid) return vec4(0.0);
    vec4 clip = frame.previousViewProjection * vec4(hitWorld, 1.0);
    if (clip.w < 0.1 || any(greaterThanEqual(abs(clip.xy), vec2(clip.w)))) return vec4(0.0);
    ivec2 pixel = ivec2((clip.xy / clip.w * 0.5 + 0.5) * frame.targetSize.xy);
    vec3 surface = texelFetch(uSurfaceHistory, pixel, 0).xyw;
    if (abs(surface.x - clip.w) > 0.12 + 0.01 * clip.w || dot(unpackNormal(surface.y), normal) < 0.6) return vec4(0.0);
    // Without the air between the eye and the position: it does not light a closed room. Bright dots met by few rays would speckle.
    vec3 fromEye = hitWorld - frame.cameraPosition.xyz;
    float range = length(fromEye);
    float haze = hazeAmount(range);
    if (haze >= 0.9) return vec4(0.0);
    vec3 radiance = texelFetch(uRadianceHistory, pixel, 0).rgb - hazeRadiance(fromEye / max(range, 1e-3)) * haze;
    if (uDiffuseOnly) radiance *= texelFetch(uDiffuseFractionHistory, pixel, 0).x;
    vec2 fromEdge = (1.0 - abs(clip.xy / clip.w)) / kScreenEdgeFade;
    float emissionScale = surface.z < 0.0 && frame.counters.z > 0 ? glow : 1.0;
    return vec4(clamp(radiance / (1.0 - haze), vec3(0.0), vec3(3.0)) * emissionScale, clamp(min(fromEdge.x, fromEdge.y), 1e-3, 1.0));
}

/// Where a path started: the mean radiance there, the lights that may reach it (lightsAt()), and random numbers for one of these.
struct PathStart {
    vec3 light, normal;
    ivec2 lights;
    vec3 random;
    vec2 directionSample;        // for the direction of the path's next ray
    float hitProximity;  // of what surrounds it (sky.frag): 0 in the open
};

PathStart startPath(vec3 light, vec3 normal, ivec2 lights) { return PathStart(light, normal, lights, vec3(0.0), vec2(0.0), 0.0); }

/// How much light a face gets under an open sky, by where it looks: all from above, a little from below.
float skyOpenness(vec3 normal) { return 0.15 + 0.85 * (0.5 + 0.5 * normal.y); }

/// What the sun sends to a face, divided by pi.
vec3 sunlightOn(vec3 position, vec3 normal) {
    float facing = dot(normal, frame.sunDirection.xyz), t;
    if (!uSunUp || facing <= 0.0 || shadowTrace(shadowOrigin(position, normal), frame.sunDirection.xyz, 64.0, t)) return vec3(0.0);
    return frame.sunColor.rgb * (facing / kPi);
}

#ifndef FEW_TEXTURE_UNITS
/// What one of the lights sends to a face, divided by pi and by how often it is drawn.
vec3 localLightOn(vec3 position, vec3 normal, PathStart start) {
    Reservoir reservoir = chooseLight(start.lights, position, normal, start.random.xy);
    if (reservoir.weightSum <= 0.0) return vec3(0.0);
    LocalLight localLight = readLight(max(reservoir.light, 0));
    vec3 toCentre = toLight(localLight, position, start.random.z), direction = sampleLightDirection(localLight, toCentre, fract(start.random.yz + start.random.x));
    LightSample point = evaluateLight(localLight, toCentre, direction, true);
    vec3 arriving = point.radiance * (max(dot(direction, normal), 0.0) / (kPi * point.pdf) * reservoir.weightSum / reservoir.weight);
    vec3 origin = shadowOrigin(position, normal), shadowRay = position + direction * point.range - origin;
    float shadowRayLength = max(length(shadowRay), 1e-4), t;
    bool dark = luminance(arriving) <= 0.0 || shadowTrace(origin, shadowRay / shadowRayLength, max(shadowRayLength - point.clearance, 0.0), t);
    return dark ? vec3(0.0) : min(arriving, vec3(max(kMaxLightRadiance, kMaxLightRadianceRatio * luminance(start.light))));
}
#endif

/// A face that no picture shows: its emitted light with what it gives back of sun and lamps, and the throughput that it gives back of all else.
struct OffscreenFace {
    vec3 radiance, reflectance;
};
OffscreenFace shadeOffscreenFace(vec3 hitWorld, vec3 normal, vec3 direction, PathStart start, float glow) {
    vec3 sun = sunlightOn(hitWorld, normal);
#ifdef FEW_TEXTURE_UNITS
    return OffscreenFace(kDefaultAlbedo * sun, vec3(kDefaultAlbedo));  // a voxel takes twelve samplers to look up
#else
    vec3 localLight = uBounceLights ? localLightOn(hitWorld, normal, start) : vec3(0.0);
    // The cell that was met has its middle in the voxel. What moves is drawn between two steps and may be a little farther on.
    vec3 middle = (floor((hitWorld - normal * (0.5 * kShadowCell)) / kShadowCell) + 0.5) * kShadowCell;
    Entry entry;
    bool found = false;
    for (int i = 0; i < 2 && !found; ++i) found = voxelAt(middle + direction * (kShadowCell * float(i)), entry);
    if (!found) return OffscreenFace(kDefaultAlbedo * (sun + localLight), vec3(kDefaultAlbedo));
    vec3 albedo = srgbToLinear(entry.color), f0 = mix(vec3(entry.reflectivity), albedo, entry.metallic);
    vec3 emitted = min(albedo * entry.emission, vec3(3.0)) * (frame.counters.z > 0 ? glow : 1.0);
    vec3 toSun = frame.sunDirection.xyz, specular = fresnel(f0, dot(-direction, normalize(toSun - direction)));
    specular *= specularLobe(normal, -direction, toSun, entry.roughness) * kPi;
    vec3 diffuse = albedo * (1.0 - entry.metallic) * (1.0 - f0), reflectance = diffuse + f0;
    return OffscreenFace(reflectance * localLight + diffuse * sun + min(specular * sun, vec3(3.0)) + emitted, reflectance);
#endif
}

/// What arrives at an unseen face from all around, if no ray asks, as a throughput of the light where the path started: as much, if both are as
/// open. That is right in the long run inside a room, where it sums up all bounces, and zero in a closed one.
float ambientShare(vec3 normal, PathStart start) {
    float opennessRatio = min(skyOpenness(normal) / skyOpenness(start.normal), kMaxOpennessRatio);
    return mix(0.9 * opennessRatio, 0.95, smoothstep(kIndoorProximity.x, kIndoorProximity.y, start.hitProximity));
}

/// What a ray meets: radiance along a path that goes on, from face to face in a random direction each, until the picture or the sky tells the
/// rest, or after uMaxBounces faces a guess.
vec3 radianceAt(vec3 hitWorld, vec3 direction, PathStart start, float glow) {
    vec3 radiance = vec3(0.0), throughput = vec3(1.0);
    if (!uBounce) return radiance;
    for (int i = 1;; ++i) {
        vec3 normal = faceNormal(hitWorld, direction);
        vec4 onScreen = radianceOnScreen(hitWorld, normal, glow);
        radiance += throughput * onScreen.a * onScreen.rgb;
        throughput *= 1.0 - onScreen.a;
        if (onScreen.a == 1.0) break;
        OffscreenFace face = shadeOffscreenFace(hitWorld, normal, direction, start, glow);
        radiance += throughput * face.radiance;
        throughput *= min(face.reflectance, vec3(kMaxReflectance));
        if (i >= uMaxBounces) {
            radiance += min(throughput * ambientShare(normal, start), vec3(kMaxReflectance)) * start.light;
            break;
        }
        vec3 origin = shadowOrigin(hitWorld, normal);
        direction = cosineDirection(normal, fract(start.directionSample + float(i) * kR2Step));
        float t;
        if (!shadowTrace(origin, direction, uMaxDistance, t)) {
            radiance += throughput * skyRadiance(direction);
            break;
        }
        hitWorld = origin + direction * t;
    }
    return radiance;
}
