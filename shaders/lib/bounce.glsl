// Radiance along a ray that has hit a surface: one estimator for sky rays, mirror rays and reflections in water.
//
// The rendering equation (Kajiya 1986) says that a hit sends back L = L_emitted + integral f L_i cos. We estimate it by
// a path. At each hit there are two sources, in this order:
//   1. Screen: if the previous frame shows the place, its lit colour is the answer (reprojection). It holds all bounces
//      of earlier frames, so light converges over time to any number of bounces. Its weight falls to 0 at the screen's
//      edge and where the light is known to have changed since; the rest of the throughput goes on to 2.
//   2. Offscreen: the voxel's material, lit by one sun ray and one ray to a light (next event estimation), and the path
//      goes on in a direction drawn in proportion to the cosine, so that the throughput is multiplied by the
//      reflectance alone.
// A path ends at the sky, or after uMaxBounces faces. There the missing light is taken to be the radiance known at the
// start of the path, scaled by how much more open the last face is: the "ambient share". In a closed room this sums the
// geometric series of all further bounces over the frames. It is biased where start and end see different surroundings.
// Needs lib/frame, gbuffer, sky, shadow_trace, sampling, brdf. With HAS_GLASS_SHADOW it needs lib/glass_shadow too, and
// the sun has the colours of glass.
#include "lib/constants.glsl"
#include "lib/surface_history.glsl"
#include "lib/color.glsl"
#include "lib/history_left.glsl"
#include "lib/local_lights.glsl"
#include "lib/voxel_walk.glsl"
#include "lib/paint.glsl"
#include "lib/voxel_at.glsl"
uniform sampler2D uRadianceHistory;         // the previous frame before post-processing
uniform sampler2D uSurfaceHistory;          // lib/surface_history.glsl
uniform sampler2D uDiffuseFractionHistory;  // passes/composite.frag
uniform bool uHistoryValid;
uniform bool uDiffuseOnly;  // takes only the diffuse fraction of the screen: its highlights belong to the camera's view
uniform bool uSunUp;
uniform bool uBounce;
uniform int uMaxBounces;     // offscreen faces of a path
uniform float uMaxDistance;  // of the path's further rays, metres
uniform bool uBounceLights;  // local lights light offscreen faces

const float kScreenEdgeFade = 0.15;  // of half the screen's size: where the screen's weight falls from 1 to 0
const float kDefaultAlbedo = 0.3;    // where no voxel is found
// Clamps against fireflies close to a light: an absolute radiance, or a multiple of that at the path's start.
const float kMaxLightRadiance = 6.0, kMaxLightRadianceRatio = 150.0;
const float kMaxOpennessRatio = 1.4;
const float kMaxHitRadiance = 3.0;  // clamp of what a hit sends: few rays meet the brightest places, as fireflies
const float kMaxEmissionRatio = 10.0, kMaxEmission = 0.3;  // see maxEmission()
const float kMaxSunDistance = 64.0;                        // metres of a shadow ray to the sun
const vec2 kIndoorProximity = vec2(0.1, 0.3);  // hit proximity between which light comes ever more from all around
const float kMaxReflectance = 0.95;            // below 1, or the ambient share of a white room would grow for ever

/// The face of a shadow cell through which a ray came to a point on it.
vec3 faceNormal(vec3 hitWorld, vec3 direction) {
    vec3 fromEdge = abs(fract(hitWorld / kShadowCell + 0.5) - 0.5);
    // A ray that hardly moves along an axis has not entered across it.
    fromEdge += 1.0 - step(0.02, abs(direction));
    if (fromEdge.x <= fromEdge.y && fromEdge.x <= fromEdge.z) return vec3(-sign(direction.x), 0, 0);
    if (fromEdge.y <= fromEdge.z) return vec3(0, -sign(direction.y), 0);
    return vec3(0, 0, -sign(direction.z));
}

/// rgb: radiance that the previous frame shows at a hit. a: its weight, 0 where the place is not visible. normal: of
/// the face that was hit. The visible surface must face the same way, or it is the far side of a thin wall.
/// maxRadiance: clamp of what a surface shows that emits. emissionWeight: factor for voxels that emit and have a light:
/// rays to that light must not count their light twice.
vec4 radianceOnScreen(vec3 hitWorld, vec3 normal, float emissionWeight, float maxRadiance) {
    if (!uHistoryValid) return vec4(0.0);
    vec4 clip = frame.previousViewProjection * vec4(hitWorld, 1.0);
    float depth = previousDepth(hitWorld);
    if (depth < 0.1 || any(greaterThanEqual(abs(clip.xy), vec2(clip.w)))) return vec4(0.0);
    ivec2 pixel = ivec2((clip.xy / clip.w * 0.5 + 0.5) * frame.targetSize.xy);
    vec3 surface = texelFetch(uSurfaceHistory, pixel, 0).xyw;
    if (abs(surface.x - depth) > 0.12 + 0.01 * depth || dot(unpackNormal(surface.y), normal) < 0.6) return vec4(0.0);
    // Without the haze between camera and surface, which would light closed rooms.
    vec3 fromEye = hitWorld - eyeOf(hitWorld);
    float range = length(fromEye);
    float haze = hazeAmount(range);
    if (haze >= 0.9) return vec4(0.0);
    vec3 radiance =
        halfRange(texelFetch(uRadianceHistory, pixel, 0).rgb) - hazeRadiance(fromEye / max(range, 1e-3)) * haze;
    if (uDiffuseOnly) radiance *= texelFetch(uDiffuseFractionHistory, pixel, 0).x;
    vec2 fromEdge = (1.0 - abs(clip.xy / clip.w)) / kScreenEdgeFade;
    float emissionScale = surface.z < 0.0 && frame.counters.z > 0 ? emissionWeight : 1.0;
    float most = surface.z < 0.0 ? min(maxRadiance, kMaxHitRadiance) : kMaxHitRadiance;
    return vec4(clamp(radiance / (1.0 - haze), vec3(0.0), vec3(most)) * emissionScale,
                clamp(min(fromEdge.x, fromEdge.y), 1e-3, 1.0) * historyLeftOf(pixel).counts);
}

/// The surface where a path started.
struct PathStart {
    vec3 light, normal;    // mean radiance that arrives there
    ivec2 lights;          // the lights that may reach it: lightsAt()
    vec3 random;           // for the choice of a light and of a point on it
    vec2 directionSample;  // for the direction of the path's next ray
    float hitProximity;    // of its surroundings (passes/sky.frag): 0 in the open
    float maxEmission;     // clamp of the radiance of voxels that emit
    int maxBounces;        // offscreen faces of the path
};

PathStart startPath(vec3 light, vec3 normal, ivec2 lights) {
    return PathStart(light, normal, lights, vec3(0.0), vec2(0.0), 0.0, kMaxHitRadiance, uMaxBounces);
}

/// Clamp of what voxels that emit send to a diffuse surface. Few rays meet a small one that is far away, and each of
/// them would be a firefly; it hardly lights the surface. One that many rays meet is soon not above kMaxEmissionRatio
/// times the light that they bring, and counts in full.
float maxEmission(vec3 light, float metres) {
    return clamp(max(kMaxEmissionRatio * luminance(light), kMaxEmission / (metres * metres)), 1e-3, kMaxHitRadiance);
}

/// Irradiance of a face under an open sky, relative to a face that looks up.
float skyOpenness(vec3 normal) { return 0.15 + 0.85 * (0.5 + 0.5 * normal.y); }

/// Irradiance of the sun on a face / pi.
vec3 sunlightOn(vec3 position, vec3 normal) {
    float facing = dot(normal, frame.sunDirection.xyz), t;
    if (!uSunUp || facing <= 0.0 ||
        shadowTrace(cellOrigin(position, normal), frame.sunDirection.xyz, kMaxSunDistance, t))
        return vec3(0.0);
    vec3 sun = frame.sunColor.rgb * (facing / kPi);
#ifdef HAS_GLASS_SHADOW
    int i = loopBegin();
    do {
        if (!uGlassShadow) break;  // a software GL leaves a loop, but runs both sides of a branch
        sun *= sunThroughGlass(position);
    } while (++i < 1);
#endif
    return sun;
}

/// Irradiance of all local lights on a face / pi, estimated with one ray to one of them (lib/local_lights.glsl).
vec3 localLightOn(vec3 position, vec3 normal, PathStart start) {
    Reservoir reservoir = chooseLight(start.lights, position, normal, start.random.xy);
    if (reservoir.weightSum <= 0.0) return vec3(0.0);
    LocalLight localLight = readLight(max(reservoir.light, 0));
    vec3 toCentre = toLight(localLight, position, start.random.z);
    SphericalRectangle face = rectangleOf(localLight, toCentre);
    vec3 direction = sampleLightDirection(localLight, toCentre, face, fract(start.random.yz + start.random.x));
    LightSample point = evaluateLight(localLight, toCentre, face, direction, true);
    vec3 arriving = point.radiance *
                    (max(dot(direction, normal), 0.0) / (kPi * point.pdf) * reservoir.weightSum / reservoir.weight);
    vec3 origin = cellOrigin(position, normal), shadowRay = position + direction * point.range - origin;
    float shadowRayLength = max(length(shadowRay), 1e-4), t;
    bool dark = luminance(arriving) <= 0.0 ||
                shadowTrace(origin, shadowRay / shadowRayLength, max(shadowRayLength - point.clearance, 0.0), t);
    return dark ? vec3(0.0)
                : min(arriving, vec3(max(kMaxLightRadiance, kMaxLightRadianceRatio * luminance(start.light))));
}

/// A face that the previous frame does not show: what it sends from sun, lights and its own emission, and its
/// reflectance for all other light.
struct OffscreenFace {
    vec3 radiance, reflectance;
};
OffscreenFace shadeOffscreenFace(vec3 hitWorld, vec3 normal, vec3 direction, PathStart start, float emissionWeight) {
    vec3 sun = sunlightOn(hitWorld, normal);
    vec3 localLight = uBounceLights ? localLightOn(hitWorld, normal, start) : vec3(0.0);
    // The centre of the shadow cell lies in the voxel. A moving body is drawn between two steps, so that its voxel may
    // be a cell farther along the ray.
    vec3 middle = (floor((hitWorld - normal * (0.5 * kShadowCell)) / kShadowCell) + 0.5) * kShadowCell;
    Entry entry;
    bool found;
    int i = loopBegin();
    do {
        found = voxelAt(middle + direction * (kShadowCell * float(i)), entry);
    } while (!found && ++i < 2);
    if (!found) return OffscreenFace(kDefaultAlbedo * (sun + localLight), vec3(kDefaultAlbedo));
    vec3 albedo = srgbToLinear(entry.color), f0 = mix(vec3(entry.reflectivity), albedo, entry.metallic);
    vec3 emitted =
        min(albedo * entry.emission, vec3(start.maxEmission)) * (frame.counters.z > 0 ? emissionWeight : 1.0);
    vec3 toSun = frame.sunDirection.xyz, specular = fresnel(f0, dot(-direction, normalize(toSun - direction)));
    specular *= specularLobe(normal, -direction, toSun, entry.roughness) * kPi;
    vec3 diffuse = albedo * (1.0 - entry.metallic) * (1.0 - f0), reflectance = diffuse + f0;
    return OffscreenFace(
        reflectance * localLight + diffuse * sun + min(specular * sun, vec3(kMaxHitRadiance)) + emitted, reflectance);
}

/// Light that arrives at the last face of a path, as a share of the light at the path's start: as much, if both are as
/// open to the sky. In a closed room the share goes to a constant, as light comes from all around there.
float ambientShare(vec3 normal, PathStart start) {
    float opennessRatio = min(skyOpenness(normal) / skyOpenness(start.normal), kMaxOpennessRatio);
    return mix(0.9 * opennessRatio, 0.95, smoothstep(kIndoorProximity.x, kIndoorProximity.y, start.hitProximity));
}

/// Radiance that a ray brings from its hit: the estimator of this file.
vec3 radianceAt(vec3 hitWorld, vec3 direction, PathStart start, float emissionWeight) {
    vec3 radiance = vec3(0.0), throughput = vec3(1.0);
    if (!uBounce) return radiance;
    for (int i = 1;; ++i) {
        vec3 normal = faceNormal(hitWorld, direction);
        vec4 onScreen = radianceOnScreen(hitWorld, normal, emissionWeight, start.maxEmission);
        radiance += throughput * onScreen.a * onScreen.rgb;
        throughput *= 1.0 - onScreen.a;
        if (onScreen.a == 1.0) break;
        OffscreenFace face = shadeOffscreenFace(hitWorld, normal, direction, start, emissionWeight);
        radiance += throughput * face.radiance;
        throughput *= min(face.reflectance, vec3(kMaxReflectance));
        if (i >= start.maxBounces) {
            radiance += min(throughput * ambientShare(normal, start), vec3(kMaxReflectance)) * start.light;
            break;
        }
        vec3 origin = cellOrigin(hitWorld, normal);
        // The factor makes the pairs of numbers of a path's rays fill the square: a step alone would tie them together.
        direction = cosineDirection(normal, fract(start.directionSample * float(12 * i - 11) + float(i) * kR2Step));
        float t;
        if (!shadowTrace(origin, direction, uMaxDistance, t)) {
            radiance += throughput * skyRadiance(direction);
            break;
        }
        hitWorld = origin + direction * t;
    }
    return radiance;
}
