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
// What the water does to panes of glass in it is a part of their light: lib/pane_light.glsl.
// Fresnel's reflectance is Schlick's with f0 = 0.02, by the angle in air (which is right on both sides).
#include "lib/constants.glsl"
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/texels.glsl"
#include "lib/sampling.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"
#include "lib/fog.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/bounce.glsl"

uniform sampler2D uBackground;                  // the image without this water
uniform ivec2 uBackgroundLow, uBackgroundHigh;  // its first and last pixel
uniform texels4f uOutline;               // sides of all waters, and boxes around runs of them: outlineCrossings()
uniform int uOutlineFirst, uOutlineEnd;  // of this water
uniform float uSurface, uBottom;         // y, metres from the render origin
// Waters to which belongs what this one shares with them, so that it absorbs light once: first and end of their texels
// of the outline, surface, bottom.
uniform vec4 uCovers[kMaxWaterCovers];
uniform int uCoverCount;
uniform vec3 uColor;       // transmittance of uClarity metres
uniform vec3 uExtinction;  // s, 1 / m
uniform vec4 uWaves;       // height and length of the longest, metres; speed, m/s; direction, radians
uniform float uSeconds;
uniform vec4 uRipples[kMaxRipples];  // xy centre (world x, z), z radius of the crest now, w height; metres
uniform int uRippleCount;
uniform bool uHasPanes;
uniform sampler2D uGlassTint;
uniform sampler2D uGlassSurface;
uniform sampler2D uPaneLightBehind;  // lib/pane_light.glsl, without this water

const float kRingWidth = 0.45;  // metres to each side of a crest
const float kRingPhase = 9.42;  // 3 pi: radians of the wave to each side of a crest
const float kRefractiveIndex = 1.33;
const float kReflectance = 0.02;     // at normal incidence
const float kMaxBend = 3.0;          // metres of water that displace what is seen through them
const float kScattering = 0.6;       // single-scattering albedo x 4 pi x phase function
const float kHistoryWeight = 0.6;    // for TAA, as waves have no motion vectors: 1 would trust history fully
const float kMinMirrorShare = 0.05;  // share of light that is worth a ray
const float kMaxRayDistance = 1e5;   // metres
const float kUsualPixel = 0.0016;    // metres of depth 1 that a pixel covers in a usual perspective
const float kMeniscus = 0.003;       // metres of height at the port that the water line covers
const float kSameDepth = 1e-3;       // metres within which two waters begin or end together

in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 paneLight;  // if uHasPanes

/// Whether a ray in the plane may meet a box of the outline (xy centre, zw half its size) beyond `begin`.
bool meetsBox(vec4 box, vec2 origin, vec2 direction, float begin) {
    vec2 middle = box.xy - origin, reach = abs(direction);
    return abs(direction.x * middle.y - direction.y * middle.x) <= dot(reach, box.wz) &&
           dot(direction, middle) + dot(reach, box.zw) > begin * dot(direction, direction);
}

/// Where a ray in the plane crosses the outline beyond `begin`.
struct Crossings {
    float first, second;  // in lengths of the direction
    bool isOdd;           // their number
};

/// Adds a side, of its two corners.
void addSide(inout Crossings found, vec4 side, vec2 origin, vec2 direction, float begin) {
    vec2 a = side.xy - origin, b = side.zw - origin;
    float asideA = direction.x * a.y - direction.y * a.x, asideB = direction.x * b.y - direction.y * b.x;
    if ((asideA > 0.0) == (asideB > 0.0)) return;
    vec2 crossing = a + (b - a) * (asideA / (asideA - asideB));
    float t = dot(crossing, direction) / dot(direction, direction);
    if (t <= begin) return;
    found.isOdd = !found.isOdd;
    found.second = min(max(t, found.first), found.second);
    found.first = min(t, found.first);
}

/// Visits the sides in boxes that the ray meets. Texels: a group is its box and kOutlineRuns runs, a run is its box and
/// kOutlineSides sides; the last ones may be shorter.
Crossings outlineCrossings(ivec2 outline, vec2 origin, vec2 direction, float begin) {
    const int kRun = 1 + kOutlineSides, kGroup = 1 + kOutlineRuns * kRun;
    Crossings found = Crossings(kSkyDepth, kSkyDepth, false);
    int group = outline.x;
    do {
        if (group >= outline.y) break;
        bool isGroupMet = meetsBox(fetch4f(uOutline, group), origin, direction, begin);
        int run = group + 1, groupEnd = min(group + kGroup, outline.y);
        do {
            if (!isGroupMet) break;
            bool isRunMet = meetsBox(fetch4f(uOutline, run), origin, direction, begin);
            int side = run + 1, runEnd = min(run + kRun, groupEnd);
            do {
                if (!isRunMet) break;
                addSide(found, fetch4f(uOutline, side), origin, direction, begin);
            } while (++side < runEnd);
        } while ((run += kRun) < groupEnd);
    } while ((group += kGroup) < outline.y);
    return found;
}

/// The first stretch of a ray, beyond `begin`, that lies inside an outline: x from, y to, in lengths of the ray. By the
/// even-odd rule a point is inside if the ray crosses an odd number of sides beyond it.
vec2 insideOutline(ivec2 outline, vec3 origin, vec3 ray, float begin) {
    vec2 direction = dot(ray.xz, ray.xz) < 1e-8 ? vec2(1e-4, 0.0) : ray.xz;
    Crossings found = outlineCrossings(outline, origin.xz, direction, begin);
    return found.isOdd ? vec2(begin, found.first) : vec2(found.first, found.second);
}

/// xy: slope of the rings on the water; z: height of their crests here.
vec3 ringSlope(vec2 p) {
    vec3 sum = vec3(0.0);
    int i = loopBegin();
    do {
        if (uRippleCount == 0) break;
        vec2 away = p - uRipples[i].xy;
        float range = length(away);
        float phase = (range - uRipples[i].z) / kRingWidth;
        if (abs(phase) < 1.0 && range >= 1e-3) {
            float window = (1.0 - phase * phase) * (1.0 - phase * phase);
            sum.xy += away / range * (uRipples[i].w * window * cos(kRingPhase * phase) * kRingPhase / kRingWidth);
            sum.z += uRipples[i].w * window * max(sin(kRingPhase * phase + 1.57), 0.0);
        }
    } while (++i < uRippleCount);
    return sum;
}

/// The depth at which a usual perspective has pixels as large as those here.
float seenFrom(float depth) { return isOrthographic() ? pixelMetres(depth) / kUsualPixel : depth; }

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
float heightOverWater(vec3 origin, vec3 ray) {
    vec3 start = origin + ray * kWaterPort;
    float over = start.y - uSurface;
    return abs(over) < 2.0 * uWaves.x ? over - waveSlope(start.xz, kWaterPort).z : over;
}

/// The part of a pixel's ray in the water, as linear depths.
struct WaterPath {
    float begin, end;
    bool isThroughTop;  // it crosses the surface: where it begins, or where it ends if it begins under water
    float covered;      // of its length, between both: what belongs to other waters
};

WaterPath pathThrough(vec3 origin, vec3 ray, float behind, bool isUnder) {
    float slope = abs(ray.y) < 1e-6 ? 1e-6 : ray.y;
    if (!isUnder && slope > 0.0) return WaterPath(0.0, 0.0, false, 0.0);
    // Between the surface and the waves a ray crosses the surface at the port.
    float top = max((uSurface - origin.y) / slope, kWaterPort), bottom = (uBottom - origin.y) / slope;
    float enter = !isUnder ? top : slope < 0.0 ? 0.0 : max(bottom, 0.0), leave = slope < 0.0 ? bottom : top;
    vec2 inside = insideOutline(ivec2(uOutlineFirst, uOutlineEnd), origin, ray, enter);
    float end = min(min(inside.y, leave), behind);
    bool isThroughTop = isUnder ? slope > 0.0 && end == leave && leave < behind : inside.x == enter;
    return WaterPath(inside.x, end, isThroughTop, 0.0);
}

/// Takes from a path what belongs to other waters.
void leaveToCovers(inout WaterPath path, vec3 origin, vec3 ray, bool isUnder) {
    float slope = abs(ray.y) < 1e-6 ? 1e-6 : ray.y;
    int i = loopBegin();
    do {
        if (uCoverCount == 0) break;
        float top = (uCovers[i].z - origin.y) / slope, bottom = (uCovers[i].w - origin.y) / slope;
        float enter = max(min(top, bottom), path.begin), leave = min(max(top, bottom), path.end);
        vec2 inside = insideOutline(ivec2(uCovers[i].xy), origin, ray, enter);
        leave = min(leave, inside.y);
        bool isShared = inside.x < leave, isFirst = isShared && inside.x <= path.begin + kSameDepth,
             isLast = isShared && leave >= path.end - kSameDepth;
        path.covered += isShared && !isFirst && !isLast ? leave - inside.x : 0.0;
        path.isThroughTop = path.isThroughTop && !(isUnder ? isLast : isFirst);
        path.end = isLast ? inside.x : path.end;
        path.begin = isFirst ? leave : path.begin;
    } while (++i < uCoverCount);
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

/// What something before a radiance does to it: `left` is the share that passes, `added` comes on top.
struct Layer {
    vec3 left, added;
};

vec3 through(Layer layer, vec3 radiance) { return radiance * layer.left + layer.added; }
Layer through(Layer layer, Layer behind) { return Layer(layer.left * behind.left, through(layer, behind.added)); }

/// A path of `metres` in the water, if it begins at a depth.
Layer waterLayer(float metres, float depth, float upward) {
    return Layer(exp(-uExtinction * metres), inscattered(metres, depth, upward));
}

/// The image without the haze that lies before it. ray: of the pixel; depth: linear.
vec3 withoutHaze(vec3 radiance, vec3 ray, float depth) {
    float stretch = length(ray), haze = depth < kSkyDepth ? hazeAmount(stretch * depth) : 0.0;
    if (haze >= 0.9) return radiance;  // little is left of it
    return max(radiance - hazeRadiance(ray / stretch) * haze, vec3(0.0)) / (1.0 - haze);
}

/// The haze before the water.
Layer hazeLayer(vec3 direction, float metres) {
    float haze = hazeAmount(metres);
    return Layer(vec3(1.0 - haze), hazeRadiance(direction) * haze);
}

/// What is seen through the surface from above: rgb colour, w its linear depth. bend: by how much the waves turn the
/// ray, for a length of 1 along the view axis.
vec4 seenBelow(vec3 origin, vec3 ray, vec3 bend, WaterPath path) {
    float deep = min(path.end - path.begin, kMaxBend);
    vec4 clip = frame.viewProjection * vec4(origin + ray * (path.begin + deep) + bend * deep, 1.0);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 bent =
        clamp(ivec2((clip.xy / max(clip.w, 1e-3) * 0.5 + 0.5) * frame.targetSize.xy), uBackgroundLow, uBackgroundHigh);
    float depth = texelFetch(uDepth, bent, 0).r;
    // Not a pixel that shows something in front of the water.
    if (depth <= path.begin) {
        bent = pixel;
        depth = path.end;
    }
    vec3 radiance = withoutHaze(texelFetch(uBackground, bent, 0).rgb, ray, depth);
    return vec4(radiance, min(depth, path.end));
}

/// Radiance that a ray from the surface brings. t: metres to what it meets.
vec3 radianceAlong(vec3 place, vec3 direction, out float t) {
    float side = direction.y > 0.0 ? 1.0 : -1.0;
    vec3 eye = toEye(place);
    vec3 origin = movedTowardEye(place + vec3(0.0, 0.01 * side, 0.0), vec3(eye.x, side * abs(eye.y), eye.z));
    vec3 light = 0.4 * skyRadiance(vec3(0, 1, 0));
    bool isMet = shadowTrace(origin, direction, kMaxRayDistance, t), isInAir = direction.y > 0.0;
    if (!isMet && isInAir) return throughOpenFog(mirroredBackground(origin, direction), origin, direction, uSunUp);
    if (!isMet) return vec3(0.0);
    vec3 radiance = radianceAt(origin + direction * t, direction, startPath(light, vec3(0, 1, 0), ivec2(0)), 1.0);
    if (!isInAir) return radiance;
    return throughFog(mix(radiance, hazeRadiance(direction), hazeAmount(t)), origin, direction, t, light, false);
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

/// What the surface shows from above beside what passes it.
struct Sheen {
    vec3 reflected, glint;
    float foam;
};

/// reflected: what the mirrored ray brings.
Sheen sheenAt(Crossing c, vec3 reflected, float below) {
    vec3 toSun = frame.sunDirection.xyz;
    vec3 glint = frame.sunColor.rgb * min(specularLobe(c.normal, -c.direction, toSun, 0.12), 30.0) *
                 max(dot(c.normal, toSun), 0.0) * c.mirrored;
    return Sheen(reflected, min(glint, vec3(20.0)), foamAt(c.place.xz, below, c.crest));
}

/// Water and the surface above it.
Layer underSurface(Layer water, Crossing c, Sheen sheen) {
    return Layer(water.left * ((1.0 - c.mirrored) * (1.0 - sheen.foam)),
                 mix(mix(water.added, sheen.reflected, c.mirrored) + sheen.glint, 0.75 * lightFromAbove(), sheen.foam));
}

/// The one ray that the surface sends, and what it brings.
struct SurfaceRay {
    vec3 direction, radiance;
    float metres;  // to what it meets
};

/// From above the mirrored ray, if it is worth one. From below the ray through Snell's window or, outside of it, the
/// one into the mirrored pool: the lesser of both is not worth a ray.
SurfaceRay sendRay(Crossing c, bool isFromBelow) {
    bool isMirror = !isFromBelow || c.mirrored > 0.5;
    vec3 mirror = reflect(c.direction, isFromBelow ? -c.normal : c.normal);
    SurfaceRay sent;
    sent.direction = atLeast(isMirror ? mirror : c.passed, isFromBelow && isMirror ? -1.0 : 1.0);
    sent.metres = 0.0;
    bool isWorthIt = isFromBelow || c.mirrored >= kMinMirrorShare;
    sent.radiance =
        isWorthIt ? radianceAlong(c.place, sent.direction, sent.metres) : skyRadiance(sent.direction);
    return sent;
}

/// Snell's window and, outside of it, the mirrored pool.
Layer surfaceFromBelow(Crossing c, SurfaceRay sent) {
    bool isMirror = c.mirrored > 0.5;
    if (!isMirror) return Layer(vec3(1.0 - c.mirrored), inscattered(kMaxRayDistance, 0.0, -1.0) * c.mirrored);
    vec3 mirrored = through(waterLayer(sent.metres, 0.0, sent.direction.y), sent.radiance);
    return Layer(vec3(0.0), mix(skyRadiance(atLeast(c.direction, 1.0)), mirrored, c.mirrored));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 origin = viewOrigin(uv), ray = viewRay(uv);
    float behind = texelFetch(uDepth, pixel, 0).r, over = heightOverWater(origin, ray);
    bool isUnder = over < 0.0;
    WaterPath path = pathThrough(origin, ray, behind, isUnder);
    leaveToCovers(path, origin, ray, isUnder);
    if (path.end <= path.begin) discard;

    float pane = uHasPanes ? texelFetch(uGlassSurface, pixel, 0).w : 0.0;
    float stretch = length(ray), metres = (path.end - path.begin - path.covered) * stretch,
          toPane = max(min(pane, path.end) - path.begin, 0.0) * stretch;
    vec3 direction = ray / stretch;
    vec4 seen = texelFetch(uBackground, pixel, 0);
    Layer water, beforePane;
    Crossing c;
    SurfaceRay sent;
    if (path.isThroughTop) {  // in one place, so that compilers inline it once: it is most of this program
        float surface = isUnder ? path.end : path.begin;
        c = crossingAt(origin + ray * surface, direction, seenFrom(surface));
        sent = sendRay(c, isUnder);
    }
    if (path.isThroughTop && !isUnder) {
        Sheen sheen = sheenAt(c, sent.radiance, (path.end - path.begin) * -ray.y);
        vec3 level = refract(direction, vec3(0, 1, 0), 1.0 / kRefractiveIndex);
        vec4 below = seenBelow(origin, ray, (c.passed - level) * stretch, path);
        water = underSurface(waterLayer(max(below.w - path.begin - path.covered, 0.0) * stretch, 0.0, c.passed.y), c,
                             sheen);
        beforePane = underSurface(waterLayer(toPane, 0.0, c.passed.y), c, sheen);
        seen = vec4(below.rgb, min(kHistoryWeight, seen.a));
    } else {
        seen.rgb = withoutHaze(seen.rgb, ray, behind);
        float depth = uSurface - origin.y - ray.y * path.begin;
        water = waterLayer(metres, depth, direction.y);
        beforePane = waterLayer(toPane, depth, direction.y);
        if (path.isThroughTop) {
            Layer surface = surfaceFromBelow(c, sent);
            if (pane > path.end) beforePane = through(water, surface);
            seen = vec4(halfRange(through(surface, sent.radiance)), min(kHistoryWeight, seen.a));
        }
        float line = path.begin <= 0.0 ? 0.5 + 0.5 * smoothstep(0.0, kMeniscus, -over) : 1.0;
        water = Layer(water.left * line, water.added * line);
        beforePane = Layer(beforePane.left * line, beforePane.added * line);
    }
    Layer haze = hazeLayer(direction, path.begin * stretch);
    beforePane = through(haze, beforePane);
    color = vec4(halfRange(through(haze, through(water, seen.rgb))), seen.a);
    if (!uHasPanes) return;
    paneLight = texelFetch(uPaneLightBehind, pixel, 0);
    if (pane <= path.begin) return;
    vec3 passing = texelFetch(uGlassTint, pixel, 0).rgb * paneLight.a;
    paneLight.rgb = halfRange(beforePane.added * (1.0 - passing) + beforePane.left * paneLight.rgb);
}
