// Temporal anti-aliasing and upsampling (Karis 2014, "High quality temporal supersampling"). Each frame is traced with
// another subpixel jitter; the resolved image is an exponential mean over the frames:
//   H' = mix(clip(H(uv - motion)), C, blend)
//   C      the new colour: Gaussian-weighted 3x3 samples around the pixel's centre, whose place the jitter moves
//   H      history, reprojected by the motion of the nearest surface around and fetched with Catmull-Rom, which stays
//          sharp over many frames
//   clip   history is clipped to mean +- 1.25 deviations of the 3x3 neighbourhood in YCoCg (Salvi 2016), as a colour
//          outside says that the surface was hidden or its light differed
//   blend  1 / frames of history, at least 0.1; 1 where something nearer has gone, as its depth says (disocclusion),
//          and where the light has changed and history lies far outside the clip box; at least what is known of
//          shapes and air that look different, as old colours of edges lie within the box
// Colours are compressed by 1 / (1 + k luminance) meanwhile, so that few bright samples do not flicker. Details finer
// than a pixel (wires, stars) are outside the box of most frames. So where nothing has moved or changed for
// kSteadyFrames, the box is widened by the deviation between jittered samples. Before that it is not, or what has gone
// would stay. Particles have no motion vectors: where they cover less than before, history counts less.
// If fewer pixels are traced than displayed, a sample counts by its distance to the displayed pixel.
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "lib/noise.glsl"
#include "lib/half.glsl"
#include "lib/surface_history.glsl"
#include "lib/change_rays.glsl"

uniform sampler2D uColor;    // a: share of the surface that shows through particles and panes
uniform sampler2D uHistory;  // a: packSteadiness()
uniform bool uHistoryValid;
uniform sampler2D uMotion;
uniform bool uHasGlass;
uniform sampler2D uGlassSurface;
uniform sampler2D uHistoryConfidence;  // passes/light_change.frag
uniform bool uHasConfidence;
uniform sampler2D uMirrorHistory;  // as `accumulated` in lib/reflection_history.glsl
uniform bool uMirrorsMayChange;    // else it is not read
uniform sampler2D uSurface;  // lib/surface_history.glsl
uniform sampler2D uSurfaceHistory;

const float kCompression = 0.04;
const float kLongHistory = 6.0;       // frames
const float kJitterDeviations = 3.0;  // deviations that the clip box is widened by
const float kSubpixelDetail = 0.04;   // relative deviation above which a pixel has details finer than a pixel
const float kStaticClipScale = 2.5;   // of the clip box where nothing has moved or changed for long, for thin lines
const float kSteadyFrames = 8.0;      // without motion or change, after which history is trusted
const float kMinBlend = 0.1;
const float kBlendRamp = 1.6;      // above 1 the first frames, which know less of the light, count less than later ones
const float kMaxBlend = 0.5;       // for a short history
const float kParticleBlend = 0.5;  // where particles cover everything: they have no motion vectors
const vec2 kUncovered = vec2(0.1, 0.4);  // decrease of what particles cover, from which on history is dropped
// Where the light has changed: how far outside the clip box history lies, from which on it is dropped. Clipped, it
// would bring the darkest or brightest colour around.
const vec2 kOutdated = vec2(1.0, 2.0);
const float kSharpness = 2.3;       // of the Gaussian around a displayed pixel
const float kSkyDistance = 4000.0;  // metres: the sky moves over the screen as what is that far away

in vec2 uv;
out vec4 resolved;

// Only colours far brighter than white are compressed much, so that edges keep their width.
vec3 compress(vec3 c) { return c / (1.0 + kCompression * luminance(c)); }
vec3 expand(vec3 c) { return c / max(1.0 - kCompression * luminance(c), 1e-3); }

/// Bicubic Catmull-Rom filter in five bilinear fetches; the corners are dropped (Jimenez 2016, "Filmic SMAA"). One
/// fetch is enough on a pixel's centre.
vec3 sampleHistory(vec2 place) {
    vec2 size = frame.displaySize.xy;
    vec2 p = place * size;
    vec2 centre = floor(p - 0.5 + kOnCentre) + 0.5;
    vec2 f = max(p - centre, vec2(0.0));
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
    vec2 w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
    vec2 w3 = f * f * (-0.5 + 0.5 * f);
    vec2 w12 = w1 + w2;
    vec2 t0 = (centre - 1.0) / size, t12 = (centre + w2 / w12) / size, t3 = (centre + 2.0) / size;
    vec4 sum = vec4(texture(uHistory, t12).rgb, 1.0) * (w12.x * w12.y);
    int i = loopBegin();
    do {  // below, above, left, right
        if (max(f.x, f.y) < kOnCentre) break;
        bool isAside = i >= 2, isHigh = (i & 1) == 1;
        vec2 side = isHigh ? t3 : t0, w = isHigh ? w3 : w0;
        sum += vec4(texture(uHistory, isAside ? vec2(side.x, t12.y) : vec2(t12.x, side.y)).rgb, 1.0) *
               (isAside ? w.x * w12.y : w12.x * w.y);
    } while (++i < 4);
    return max(sum.rgb / sum.a, vec3(0.0));
}

/// What a pixel remembers beside its colour.
struct Steadiness {
    float steady;     // 0 to 1: the share of kSteadyFrames for which nothing has moved or changed
    float deviation;  // mean deviation of samples from the mean while steady is 1, in compressed luminance
    float covered;    // share of what has no motion vectors: particles, waves, panes; only where steady is 0
};

/// In one number: 1 or more where steady, above that the deviation; below 0 the share that is covered.
float packSteadiness(Steadiness s) { return s.steady > 0.0 ? s.steady + s.deviation : -s.covered; }
Steadiness unpackSteadiness(float packed_) {
    return Steadiness(clamp(packed_, 0.0, 1.0), max(packed_ - 1.0, 0.0), max(-packed_, 0.0));
}

/// Motion of a point that stands still in the world, seen at a place of the screen.
vec2 staticPointMotion(vec2 place, float depth) {
    vec4 before = frame.previousViewProjection * vec4(worldFromDepth(place, depth), 1.0);
    return place + frame.jitter.xy - (before.xy / max(before.w, 1e-4) * 0.5 + 0.5);
}

/// Gaussian weights, with a sum of 1, of three samples in a row of which the middle one is `fromSample` off the pixel.
vec3 gaussian(float fromSample, float sharpness) {
    float side = exp(-sharpness), ratio = exp(-2.0 * sharpness * fromSample);
    vec3 weights = vec3(side / ratio, 1.0, side * ratio);
    return weights / (weights.x + weights.y + weights.z);
}

/// The 3x3 traced pixels around a displayed one.
struct Neighbourhood {
    vec3 now;                             // weighted mean colour: compressed, YCoCg
    vec3 boxLow, boxHigh;                 // the clip box
    float depth;                          // least
    ivec2 nearest, panePixel;             // the pixel of that depth; the one with the least share of its surface
    float surfaceShare, maxSurfaceShare;  // least and largest share of the surface that shows through
    float frames;                         // longest history
};

Neighbourhood gatherNeighbourhood(ivec2 pixel, vec3 across, vec3 up) {
    ivec2 high = ivec2(frame.targetSize.xy) - 1;
    vec3 sum = vec3(0.0), squares = vec3(0.0), low = vec3(1e9), top = vec3(-1e9);
    Neighbourhood n = Neighbourhood(vec3(0.0), vec3(0.0), vec3(0.0), 1e9, pixel, pixel, 1.0, 0.0, 0.0);
    for (int i = 0; i < 9; ++i) {
        ivec2 offset = ivec2(i % 3, i / 3) - 1;
        ivec2 p = clamp(pixel + offset, ivec2(0), high);
        vec4 there = texelFetch(uColor, p, 0);
        n.panePixel = there.a < n.surfaceShare ? p : n.panePixel;
        n.surfaceShare = min(n.surfaceShare, there.a);
        n.maxSurfaceShare = max(n.maxSurfaceShare, there.a);
        vec3 c = toYCoCg(compress(halfRange(there.rgb)));  // a sum of passes
        sum += c;
        squares += c * c;
        low = min(low, c);
        top = max(top, c);
        n.now += c * (across[i % 3] * up[i / 3]);
        if (i % 2 == 1) continue;  // corners and centre are enough to find an edge in front
        vec4 surface = texelFetch(uSurface, p, 0);
        // The longest history around: changes are wider than a pixel, and one pixel alone may just have missed its own.
        n.frames = max(n.frames, floor(surface.z));
        if (surface.x < n.depth) {
            n.depth = surface.x;
            n.nearest = p;
        }
    }
    vec3 mean = sum / 9.0;
    vec3 deviation = sqrt(max(squares / 9.0 - mean * mean, vec3(0.0)));
    n.boxLow = max(low, mean - 1.25 * deviation), n.boxHigh = min(top, mean + 1.25 * deviation);
    return n;
}

/// Motion of the nearest surface around, so that edges move with what is in front; the sky moves with the camera. A
/// pane moves with what is behind it, but its edge moves with itself.
vec2 motionOf(Neighbourhood n) {
    // Panes always take some light: a pixel where nothing is lost beside one where something is may be a pane's edge.
    float pane = uHasGlass ? texelFetch(uGlassSurface, n.panePixel, 0).w : 0.0;
    bool isPaneEdge = pane > 0.0 && pane < n.depth && n.maxSurfaceShare > 0.99;
    vec2 motion = staticPointMotion(isPaneEdge ? (vec2(n.panePixel) + 0.5) * frame.targetSize.zw : uv,
                                    isPaneEdge ? pane : kSkyDistance);
    if (!isPaneEdge && n.depth < kSkyDepth) motion = texelFetch(uMotion, n.nearest, 0).rg;
    return motion;
}

/// Whether something nearer than what is seen now was before it in the previous frame. Where it is not asked, a loop of
/// no steps costs less than a branch on a GL that runs both sides of it.
bool isDisoccluded(Neighbourhood n, vec2 before, bool isAsked) {
    float expected = kSkyDepth, tolerance = 0.0;
    if (n.depth < kSkyDepth) {
        vec3 position = worldFromDepth((vec2(n.nearest) + 0.5) * frame.targetSize.zw, n.depth);
        expected = previousDepth(position);
        tolerance = depthTolerance(position, unpackNormal(texelFetch(uSurface, n.nearest, 0).y), n.depth);
    }
    ivec2 middle = ivec2(before * frame.targetSize.xy), high = ivec2(frame.targetSize.xy) - 1;
    float nearest = kSkyDepth;
    int i = loopBegin();
    do {
        if (!isAsked) break;
        nearest =
            min(nearest, texelFetch(uSurfaceHistory, clamp(middle + ivec2(i % 3, i / 3) - 1, ivec2(0), high), 0).x);
    } while ((i += 2) < 9);
    return nearest < expected - tolerance;
}

void main() {
    // The traced sample nearest to this pixel and its offset, in traced pixels.
    vec2 place = (uv - frame.jitter.xy) * frame.targetSize.xy;
    vec2 fromSample = floor(place) + 0.5 - place;
    float upscale = frame.displaySize.x * frame.targetSize.z, sharpness = kSharpness * upscale * upscale;
    Neighbourhood n =
        gatherNeighbourhood(ivec2(place), gaussian(fromSample.x, sharpness), gaussian(fromSample.y, sharpness));
    // What lies behind a pane moves as the pane's pixels do, nearly.
    bool isPane = uHasGlass && texelFetch(uGlassSurface, n.panePixel, 0).w > 0.0;
    float covered = isPane ? 0.0 : 1.0 - n.surfaceShare;
    resolved = vec4(expand(fromYCoCg(n.now)), -covered);
    vec2 motion = motionOf(n);
    vec2 before = uv - motion;
    if (!uHistoryValid || any(lessThan(before, vec2(0.0))) || any(greaterThan(before, vec2(1.0)))) return;
    vec3 history = toYCoCg(compress(sampleHistory(before)));
    Steadiness last = unpackSteadiness(texelFetch(uHistory, ivec2(before * frame.displaySize.xy), 0).a);
    vec3 confidence = uHasConfidence ? texture(uHistoryConfidence, uv).xyz : vec3(1.0);
    if (uMirrorsMayChange && texelFetch(uMirrorHistory, ivec2(place), 0).a < 0.0) confidence.y = 0.0;
    float frames = n.depth >= kSkyDepth ? kLongHistory : n.frames;
    bool isSteady =
        covered == 0.0 && length(motion * frame.targetSize.xy) < 0.05 && min(confidence.y, confidence.z) > 0.5;
    bool isTrusted = isSteady && !isPane && last.steady == 1.0 && frames >= kLongHistory;
    float deviation = isSteady ? confidence.x * last.deviation : 0.0;
    vec3 middle = 0.5 * (n.boxLow + n.boxHigh);
    vec3 extent =
        0.5 * (n.boxHigh - n.boxLow) * (isTrusted ? kStaticClipScale : 1.0) + kJitterDeviations * deviation + 1e-4;
    vec3 offset = history - middle;
    vec3 ratio = abs(offset / extent);
    float outside = max(ratio.x, max(ratio.y, ratio.z));
    if (outside > 1.0) history = middle + offset / outside;
    float steady = isSteady ? min(last.steady + 1.0 / kSteadyFrames, 1.0) : 0.0;
    resolved.a = packSteadiness(Steadiness(
        steady, steady == 1.0 && !isPane ? confidence.x * mix(deviation, abs(n.now.x - history.x), kMinBlend) : 0.0,
        covered));
    // Details finer than a pixel change their surface with each jitter: the number of frames drawn counts for them.
    if (deviation > kSubpixelDetail * history.x) frames = max(frames, float(min(frame.counters.x, 64)));
    // A frame of many rays counts as many frames of light, but as one of edges.
    frames = confidence.y < 0.5 ? 1.0 : wasDropped(before) ? min(frames, 2.0) : frames;
    float blend = clamp(kBlendRamp / (frames + kBlendRamp - 1.0), kMinBlend, kMaxBlend);
    if (confidence.y < 0.5) blend = mix(blend, 1.0, smoothstep(kOutdated.x, kOutdated.y, outside));
    blend = mix(kParticleBlend, blend, n.surfaceShare);
    blend = max(blend, 1.0 - confidence.z);
    blend = max(blend, smoothstep(kUncovered.x, kUncovered.y, last.covered - covered));
    if (isDisoccluded(n, before, !isTrusted && last.steady < 0.5)) blend = 1.0;
    float near = upscale > 1.0 ? exp(-0.5 * sharpness * dot(fromSample, fromSample)) : 1.0;
    resolved.rgb = expand(fromYCoCg(mix(history, n.now, near * blend)));
    resolved = stochasticRoundToHalf(resolved, ivec2(gl_FragCoord.xy), 0);
}
