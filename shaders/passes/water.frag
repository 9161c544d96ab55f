// Composites a body of water over a copy of the image: a prism under a polygon, whose top has waves and rings. A
// pixel's ray enters it through the top or a side, or begins in it, and leaves it at what lies behind, through the top
// or a side. Whether it begins in the water is asked a little before the eye, as if at the port of a camera's
// housing, so that a camera half under water shows a water line.
//   Absorption    exp(-s metres) along the path, with s = -log(uColor) / uClarity (Beer-Lambert)
//   In-scattering sunlight and skylight come from straight above, so that at a depth d exp(-s d) of them is left. The
//                 path sends the albedo times integral_0^L s exp(-s t) exp(-s d(t)) dt, which has a closed form
//   From above    what is below is displaced by the waves' refraction; one mirror ray; the sun's glint; foam
//   From below    Snell's window: one ray refracted into the air where the surface lets light through, or reflected
//                 where it mirrors, which it does totally from the critical angle on
// Fresnel's reflectance is Schlick's with f0 = 0.02, by the angle in air (which is right on both sides).
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
uniform ivec2 uBackgroundLow, uBackgroundHigh;            // its first and last pixel
uniform mat4 uOutline0, uOutline1, uOutline2, uOutline3;  // corners x, z, x, z ...
uniform int uCornerCount;
uniform float uSurface, uBottom;  // y, metres from the render origin
uniform vec3 uColor;              // transmittance of uClarity metres
uniform vec3 uExtinction;         // s, 1 / m
uniform vec4 uWaves;              // height and length of the longest, metres; speed, m/s; direction, radians
uniform float uSeconds;
uniform vec4 uRipples[kMaxRipples];  // xy centre (world x, z), z radius of the crest now, w height; metres
uniform int uRippleCount;

const float kRingWidth = 0.45;  // metres to each side of a crest
const float kRingPhase = 9.42;  // 3 pi: radians of the wave to each side of a crest
const float kRefractiveIndex = 1.33;
const float kReflectance = 0.02;     // at normal incidence
const float kMaxBend = 3.0;          // metres of water that displace what is seen through them
const float kScattering = 0.6;       // single-scattering albedo x 4 pi x phase function
const float kHistoryWeight = 0.6;    // for TAA, as waves have no motion vectors: 1 would trust history fully
const float kMinMirrorShare = 0.05;  // share of light that is worth a ray
const float kMaxRayDistance = 1e5;   // metres
const float kMeniscus = 0.003;       // metres of height at the port that the water line covers

in vec2 uv;
out vec4 color;

/// Corner i of the outline: x, z.
vec2 cornerAt(int i) {
    mat4 part = i < 8 ? uOutline0 : i < 16 ? uOutline1 : i < 24 ? uOutline2 : uOutline3;
    vec4 pair = part[(i & 7) >> 1];
    return (i & 1) == 0 ? pair.xy : pair.zw;
}

/// The first stretch of a ray in the plane, beyond `begin`, that lies inside the outline: x from, y to, in lengths of
/// the direction. By the even-odd rule a point is inside if the ray crosses an odd number of edges beyond it.
vec2 insideOutline(vec2 origin, vec2 direction, float begin) {
    float first = kSkyDepth, second = kSkyDepth;
    bool inside = false;
    for (int i = 0, j = uCornerCount - 1; i < uCornerCount; j = i++) {
        vec2 a = cornerAt(i) - origin, b = cornerAt(j) - origin;
        float asideA = direction.x * a.y - direction.y * a.x, asideB = direction.x * b.y - direction.y * b.x;
        if ((asideA > 0.0) == (asideB > 0.0)) continue;
        vec2 crossing = a + (b - a) * (asideA / (asideA - asideB));
        float t = dot(crossing, direction) / dot(direction, direction);
        if (t <= begin) continue;
        inside = !inside;
        second = min(max(t, first), second);
        first = min(t, first);
    }
    return inside ? vec2(begin, first) : vec2(first, second);
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

/// Seven sines, the longest first, each rotated by the golden angle. xy: their slope, z: their height, metres.
vec3 waveSlope(vec2 p, float far) {
    vec3 sum = vec3(0.0);
    float angle = uWaves.w, wavelength = uWaves.y, height = uWaves.x * 0.5;
    for (int i = 0; i < 7; ++i) {
        vec2 along = vec2(cos(angle), sin(angle));
        float k = kTwoPi / wavelength;
        float fade = 1.0 / (1.0 + far * far * k * k * 2e-4);  // ripples below a pixel average out
        float phase = k * (dot(p, along) - uWaves.z * sqrt(wavelength / uWaves.y) * uSeconds) + float(i) * 2.1;
        sum += height * fade * vec3(along * (k * cos(phase)), sin(phase));
        angle += 2.3999632;
        wavelength *= 0.71;
        height *= 0.60;
    }
    return sum;
}

/// Height of a ray's start over the water. The waves count only close to the surface.
float heightOverWater(vec3 ray) {
    vec3 start = frame.cameraPosition.xyz + ray * kWaterPort;
    float over = start.y - uSurface;
    return abs(over) < 2.0 * uWaves.x ? over - waveSlope(start.xz, kWaterPort).z : over;
}

/// The part of a pixel's ray in the water, as linear depths.
struct WaterPath {
    float begin, end;
    bool isThroughTop;  // it crosses the surface: where it begins, or where it ends if it begins under water
};

WaterPath pathThrough(vec3 ray, float behind, bool isUnder) {
    vec3 origin = frame.cameraPosition.xyz;
    float slope = abs(ray.y) < 1e-6 ? 1e-6 : ray.y;
    if (!isUnder && slope > 0.0) return WaterPath(0.0, 0.0, false);
    // Between the surface and the waves a ray crosses the surface at the port.
    float top = max((uSurface - origin.y) / slope, kWaterPort), bottom = (uBottom - origin.y) / slope;
    float enter = !isUnder ? top : slope < 0.0 ? 0.0 : max(bottom, 0.0), leave = slope < 0.0 ? bottom : top;
    vec2 inside = insideOutline(origin.xz, dot(ray.xz, ray.xz) < 1e-8 ? vec2(1e-4, 0.0) : ray.xz, enter);
    float end = min(min(inside.y, leave), behind);
    bool isThroughTop = isUnder ? slope > 0.0 && end == leave && leave < behind : inside.x == enter;
    return WaterPath(inside.x, end, isThroughTop);
}

/// Mean radiance from above.
vec3 lightFromAbove() {
    return skyRadiance(vec3(0, 1, 0)) + frame.sunColor.rgb * max(frame.sunDirection.y, 0.0) * kInversePi;
}

/// Light that a path of `metres` in a direction scatters to the eye, if it begins at a depth.
vec3 inscattered(float metres, float depth, float upward) {
    float slant = max(1.0 - upward, 0.02);
    return kScattering * uColor * lightFromAbove() * exp(-uExtinction * max(depth, 0.0)) *
           (1.0 - exp(-uExtinction * metres * slant)) / slant;
}

/// What water that is seen through shows of a radiance behind it.
vec3 throughWater(vec3 radiance, float metres, float depth, float upward) {
    return radiance * exp(-uExtinction * metres) + inscattered(metres, depth, upward);
}

/// What is seen through the surface from above: rgb colour, w its linear depth. bend: by how much the waves turn the
/// ray, for a length of 1 along the view axis.
vec4 seenBelow(vec3 ray, vec3 bend, WaterPath path) {
    float deep = min(path.end - path.begin, kMaxBend);
    vec4 clip = frame.viewProjection * vec4(frame.cameraPosition.xyz + ray * (path.begin + deep) + bend * deep, 1.0);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 bent =
        clamp(ivec2((clip.xy / max(clip.w, 1e-3) * 0.5 + 0.5) * frame.targetSize.xy), uBackgroundLow, uBackgroundHigh);
    float depth = texelFetch(uDepth, bent, 0).r;
    // Not a pixel that shows something in front of the water.
    if (depth <= path.begin) {
        bent = pixel;
        depth = path.end;
    }
    return vec4(texelFetch(uBackground, bent, 0).rgb, min(depth, path.end));
}

/// Radiance that a ray from the surface brings. t: metres to what it meets.
vec3 radianceAlong(vec3 place, vec3 direction, out float t) {
    vec3 origin = place + vec3(0.0, direction.y > 0.0 ? 0.01 : -0.01, 0.0);
    if (shadowTrace(origin, direction, kMaxRayDistance, t))
        return mix(radianceAt(origin + direction * t, direction,
                              startPath(0.4 * skyRadiance(vec3(0, 1, 0)), vec3(0, 1, 0), ivec2(0)), 1.0),
                   hazeRadiance(direction), direction.y > 0.0 ? hazeAmount(t) : 0.0);
    return direction.y > 0.0 ? mirroredBackground(origin, direction) : vec3(0.0);
}

/// A direction that points away from the water, or into it, by at least a little.
vec3 atLeast(vec3 direction, float upward) {
    return normalize(vec3(direction.x, upward * max(direction.y * upward, 0.03), direction.z));
}

/// Share of foam: along the shore, and on high rings.
float foamAt(vec2 place, float below, float crest) {
    float bubbles = fractalNoise(place * 7.0 + uSeconds * 0.15, 3);
    float shore = (1.0 - smoothstep(0.0, 0.14, below)) * 0.9;
    return smoothstep(0.62, 0.80, bubbles * 0.55 + shore * 0.5 + min(crest * 14.0, 0.45));
}

/// The surface as both sides see it. The ray that it sends is either the mirrored one or the one that passes.
struct Crossing {
    vec3 place, normal;  // up
    vec3 direction;      // of the eye's ray, a unit vector
    vec3 passed;         // direction beyond the surface; 0 where it mirrors totally
    float mirrored;      // Fresnel's reflectance
    float crest;         // height of rings
};

Crossing crossingAt(vec3 place, vec3 direction, float far) {
    vec3 rings = ringSlope(place.xz);
    vec2 slope = waveSlope(place.xz, far).xy + rings.xy;
    vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
    bool isFromBelow = direction.y > 0.0;
    vec3 facing = isFromBelow ? -normal : normal;
    vec3 passed = refract(direction, facing, isFromBelow ? kRefractiveIndex : 1.0 / kRefractiveIndex);
    float inAir = isFromBelow ? dot(passed, normal) : max(dot(normal, -direction), 0.0);
    return Crossing(place, normal, direction, passed, fresnel(vec3(kReflectance), inAir).r, rings.z);
}

vec3 surfaceFromAbove(Crossing c, vec3 ray, float stretch, WaterPath path) {
    vec3 level = refract(c.direction, vec3(0, 1, 0), 1.0 / kRefractiveIndex);
    vec4 below = seenBelow(ray, (c.passed - level) * stretch, path);
    vec3 seen = throughWater(below.rgb, (below.w - path.begin) * stretch, 0.0, c.passed.y);
    vec3 mirror = atLeast(reflect(c.direction, c.normal), 1.0);
    float t;
    vec3 reflected = c.mirrored < kMinMirrorShare ? skyRadiance(mirror) : radianceAlong(c.place, mirror, t);
    vec3 toSun = frame.sunDirection.xyz;
    vec3 glint = frame.sunColor.rgb * min(specularLobe(c.normal, -c.direction, toSun, 0.12), 30.0) *
                 max(dot(c.normal, toSun), 0.0) * c.mirrored;
    float foam = foamAt(c.place.xz, (path.end - path.begin) * -ray.y, c.crest);
    return mix(mix(seen, reflected, c.mirrored) + min(glint, vec3(20.0)), 0.75 * lightFromAbove(), foam);
}

/// Snell's window and, outside of it, the mirrored pool. The lesser of both is not worth a ray.
vec3 surfaceFromBelow(Crossing c) {
    bool isMirror = c.mirrored > 0.5;
    vec3 direction = isMirror ? atLeast(reflect(c.direction, -c.normal), -1.0) : atLeast(c.passed, 1.0);
    float t;
    vec3 radiance = radianceAlong(c.place, direction, t);
    if (isMirror)
        return mix(skyRadiance(atLeast(c.direction, 1.0)), throughWater(radiance, t, 0.0, direction.y), c.mirrored);
    return mix(radiance, inscattered(kMaxRayDistance, 0.0, -1.0), c.mirrored);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 ray = viewRay(uv);
    float behind = texelFetch(uDepth, pixel, 0).r, over = heightOverWater(ray);
    bool isUnder = over < 0.0;
    WaterPath path = pathThrough(ray, behind, isUnder);
    if (path.end <= path.begin) discard;

    float stretch = length(ray), metres = (path.end - path.begin) * stretch;
    vec3 direction = ray / stretch, origin = frame.cameraPosition.xyz;
    color = texelFetch(uBackground, pixel, 0);
    if (path.isThroughTop) {
        float depth = isUnder ? path.end : path.begin;
        Crossing c = crossingAt(origin + ray * depth, direction, depth);
        color = vec4(halfRange(isUnder ? surfaceFromBelow(c) : surfaceFromAbove(c, ray, stretch, path)),
                     min(kHistoryWeight, color.a));
    }
    if (path.isThroughTop && !isUnder) return;
    color.rgb = throughWater(color.rgb, metres, uSurface - origin.y - ray.y * path.begin, direction.y);
    if (path.begin <= 0.0) color.rgb *= 0.5 + 0.5 * smoothstep(0.0, kMeniscus, -over);
    color.rgb = halfRange(color.rgb);
}
