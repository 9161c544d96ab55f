// Composites a water surface over a copy of the image. It is a horizontal plane within a polygon, with a normal from
// sums of sines and of rings. What is below is refracted (displaced by the slope) and absorbed: by
// color^(path / clarity) (Beer-Lambert). Fresnel's reflectance (f0 = 0.02) mixes it with the reflection of one ray, the
// sun's glint and foam.
#include "lib/constants.glsl"
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/bounce.glsl"

uniform sampler2D uBackground;                            // the image without this water
uniform mat4 uOutline0, uOutline1, uOutline2, uOutline3;  // corners x, z, x, z ...
uniform int uCornerCount;
uniform float uSurface;  // y, metres from the render origin
uniform vec3 uColor;     // transmittance of uClarity metres
uniform float uClarity;  // metres
uniform vec4 uWaves;     // height and length of the longest, metres; speed, m/s; direction, radians
uniform float uSeconds;
uniform vec4 uRipples[kMaxRipples];  // xy centre (world x, z), z radius of the crest now, w height; metres
uniform int uRippleCount;

const float kRingWidth = 0.45;          // metres to each side of a crest
const float kRingPhase = 9.42;          // 3 pi: radians of the wave to each side of a crest
const float kRefraction = 0.35;         // metres of displacement for a slope of 1 and a metre of depth
const float kHistoryWeight = 0.6;       // for TAA, as waves have no motion vectors: 1 would trust history fully
const float kMinMirrorShare = 0.05;     // share of light that is worth a ray
const float kMaxMirrorDistance = 40.0;  // metres

in vec2 uv;
out vec4 color;

/// Corner i of the outline: x, z.
vec2 cornerAt(int i) {
    mat4 part = i < 8 ? uOutline0 : i < 16 ? uOutline1 : i < 24 ? uOutline2 : uOutline3;
    vec4 pair = part[(i & 7) >> 1];
    return (i & 1) == 0 ? pair.xy : pair.zw;
}

/// Even-odd rule: counts the edges that a horizontal ray crosses.
bool insideOutline(vec2 p) {
    bool inside = false;
    for (int i = 0, j = uCornerCount - 1; i < uCornerCount; j = i++) {
        vec2 a = cornerAt(i), b = cornerAt(j);
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
}

/// xy: slope of the rings on the water; z: height of their crests here.
vec3 ringSlope(vec2 p) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < uRippleCount; ++i) {
        vec2 away = p - uRipples[i].xy;
        float range = length(away);
        float phase = (range - uRipples[i].z) / kRingWidth;
        if (abs(phase) >= 1.0 || range < 1e-3) continue;
        float window = (1.0 - phase * phase) * (1.0 - phase * phase);
        sum.xy += away / range * (uRipples[i].w * window * cos(kRingPhase * phase) * kRingPhase / kRingWidth);
        sum.z += uRipples[i].w * window * max(sin(kRingPhase * phase + 1.57), 0.0);
    }
    return sum;
}

/// Slope of seven sines, the longest first, each rotated by the golden angle.
vec2 rippleSlope(vec2 p, float far) {
    vec2 slope = vec2(0.0);
    float angle = uWaves.w, wavelength = uWaves.y, height = uWaves.x * 0.5;
    for (int i = 0; i < 7; ++i) {
        vec2 along = vec2(cos(angle), sin(angle));
        float k = kTwoPi / wavelength;
        float fade = 1.0 / (1.0 + far * far * k * k * 2e-4);  // ripples below a pixel average out
        slope +=
            along * (k * height * fade *
                     cos(k * (dot(p, along) - uWaves.z * sqrt(wavelength / uWaves.y) * uSeconds) + float(i) * 2.1));
        angle += 2.3999632;
        wavelength *= 0.71;
        height *= 0.60;
    }
    return slope;
}

/// What is seen through the surface: rgb colour, w length of the path through the water, metres.
vec4 refractedBelow(vec3 place, vec2 slope, float t, float behind, float stretch) {
    float deep = min(behind - t, 3.0);
    vec4 clip = frame.viewProjection * vec4(place - vec3(slope.x, 0.0, slope.y) * (kRefraction * deep), 1.0);
    vec4 straight = frame.viewProjection * vec4(place, 1.0);
    ivec2 shift = ivec2((clip.xy / clip.w - straight.xy / straight.w) * 0.5 * frame.targetSize.xy);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 bent = clamp(pixel + shift, ivec2(0), ivec2(frame.targetSize.xy) - 1);
    float bentDepth = texelFetch(uDepth, bent, 0).r;
    // Not a pixel that shows something in front of the water.
    if (bentDepth <= t) {
        bent = pixel;
        bentDepth = behind;
    }
    return vec4(texelFetch(uBackground, bent, 0).rgb, min((bentDepth - t) * stretch, 50.0));
}

/// Reflected radiance. share: of the light that is reflected; little of it is not worth a ray, and the sky must do.
vec3 mirroredRadiance(vec3 place, vec3 normal, vec3 direction, float share) {
    vec3 mirror = reflect(direction, normal);
    mirror = normalize(vec3(mirror.x, max(mirror.y, 0.03), mirror.z));
    if (share < kMinMirrorShare) return skyRadiance(mirror);
    float t;
    vec3 origin = place + vec3(0.0, 0.01, 0.0);
    if (shadowTrace(origin, mirror, kMaxMirrorDistance, t))
        return radianceAt(origin + mirror * t, mirror,
                          startPath(0.4 * skyRadiance(vec3(0, 1, 0)), vec3(0, 1, 0), ivec2(0)), 1.0);
    return withHills(withClouds(skyRadiance(mirror), mirror), mirror);
}

/// Share of foam: along the shore, and on high rings.
float foamAt(vec2 place, float below, float crest) {
    float bubbles = fractalNoise(place * 7.0 + uSeconds * 0.15, 3);
    float shore = (1.0 - smoothstep(0.0, 0.14, below)) * 0.9;
    return smoothstep(0.62, 0.80, bubbles * 0.55 + shore * 0.5 + min(crest * 14.0, 0.45));
}

void main() {
    vec3 ray = viewRay(uv);
    float over = frame.cameraPosition.y - uSurface;
    if (over <= 0.0 || ray.y >= 0.0) discard;
    float t = -over / ray.y;  // linear depth of the surface
    float behind = texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r;
    vec3 place = frame.cameraPosition.xyz + ray * t;
    if (t >= behind || !insideOutline(place.xz)) discard;

    float stretch = length(ray);
    vec3 direction = ray / stretch;
    vec3 rings = ringSlope(place.xz);
    vec2 slope = rippleSlope(place.xz, t) + rings.xy;
    vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
    float mirrored = fresnel(vec3(0.02), max(dot(normal, -direction), 0.0)).r;
    vec4 below = refractedBelow(place, slope, t, behind, stretch);
    vec3 left = pow(uColor, vec3(below.w / uClarity));
    vec3 light = skyRadiance(vec3(0, 1, 0)) + frame.sunColor.rgb * max(frame.sunDirection.y, 0.0) * kInversePi;
    vec3 scattered = uColor * light * 0.35 * (1.0 - left);
    vec3 glint = frame.sunColor.rgb * min(specularLobe(normal, -direction, frame.sunDirection.xyz, 0.12), 30.0) *
                 max(dot(normal, frame.sunDirection.xyz), 0.0) * mirrored;
    vec3 water = (below.rgb * left + scattered) * (1.0 - mirrored) +
                 mirroredRadiance(place, normal, direction, mirrored) * mirrored + min(glint, vec3(20.0));
    float foam = foamAt(place.xz, (behind - t) * -ray.y, rings.z);
    color = vec4(mix(water, 0.75 * light, foam), kHistoryWeight);
}
