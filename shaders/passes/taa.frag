// Temporal anti-aliasing: the jittered picture mixed into its own history, which is fetched sharply (Catmull-Rom) and
// clipped to the colours around the pixel (Karis 2014; Salvi 2016). Radiance is compressed meanwhile, so that bright points do not flicker.
// Where nothing moves, what a pixel has shown from one jittered place to the next widens the clip: details finer than a pixel average out.
// Where fewer pixels are traced than shown, each sample counts most for the pixel that it lies in (Karis 2014, "Temporal upsampling").
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "lib/noise.glsl"
#include "lib/half.glsl"
#include "shared/constants.h"

uniform sampler2D uColor;  // a: blend of the surface that shows through particles
uniform sampler2D uHistory;  // a: how far samples stray from the mean where nothing moves, in compressed luminance
uniform bool uHistoryValid;
uniform sampler2D uMotion;
uniform bool uHasGlass;
uniform sampler2D uGlassSurface;
uniform sampler2D uHistoryConfidence;    // x: 0 where the light has just changed (light_change.frag)
uniform bool uHasConfidence;
uniform sampler2D uSurface;    // x depth, z frames accumulated (lib/surface_history.glsl)

const float kCompression = 0.04;
const float kLongHistory = 6.0;  // frames
const float kJitterDeviations = 3.0;  // times that, which memory may leave the colours around it
const float kSubpixelDetail = 0.04;  // of the luminance: what jitterDeviation by more shows details finer than a pixel
const float kStaticClipScale = 2.5;  // times the box that holds memory, where nothing has moved or changed for long: thin lines live on between samples
const float kMinBlend = 0.1;
const float kBlendRamp = 1.6;  // above 1 the first pictures, which know less of the light, count less than the later ones
const float kMaxBlend = 0.5;  // where memory is short
const float kParticleBlend = 0.5;  // where particles cover all: they have no motion to follow
const float kSharpness = 2.3;      // of the gaussian around a pixel, in pixels of the picture

in vec2 uv;
out vec4 resolved;

// Only what is far brighter than white counts much less: edges stay as wide as they are.
vec3 compress(vec3 c) { return c / (1.0 + kCompression * luminance(c)); }
vec3 expand(vec3 c) { return c / max(1.0 - kCompression * luminance(c), 1e-3); }

/// Nine taps of Catmull-Rom in five bilinear fetches: the corners are dropped (Jimenez 2016).
vec3 sampleHistory(vec2 place) {
    vec2 size = frame.displaySize.xy;
    vec2 p = place * size;
    vec2 centre = floor(p - 0.5) + 0.5;
    vec2 f = p - centre;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
    vec2 w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
    vec2 w3 = f * f * (-0.5 + 0.5 * f);
    vec2 w12 = w1 + w2;
    vec2 t0 = (centre - 1.0) / size, t12 = (centre + w2 / w12) / size, t3 = (centre + 2.0) / size;
    vec4 sum = vec4(texture(uHistory, vec2(t12.x, t0.y)).rgb, 1.0) * (w12.x * w0.y);
    sum += vec4(texture(uHistory, vec2(t0.x, t12.y)).rgb, 1.0) * (w0.x * w12.y);
    sum += vec4(texture(uHistory, t12).rgb, 1.0) * (w12.x * w12.y);
    sum += vec4(texture(uHistory, vec2(t3.x, t12.y)).rgb, 1.0) * (w3.x * w12.y);
    sum += vec4(texture(uHistory, vec2(t12.x, t3.y)).rgb, 1.0) * (w12.x * w3.y);
    return max(sum.rgb / sum.a, vec3(0.0));
}

/// Motion of a point that stands still in the world, seen at a place of the screen.
vec2 staticPointMotion(vec2 place, float depth) {
    vec4 before = frame.previousViewProjection * vec4(frame.cameraPosition.xyz + viewRay(place) * depth, 1.0);
    return place + frame.jitter.xy - (before.xy / max(before.w, 1e-4) * 0.5 + 0.5);
}

/// Weights of three samples in a row of which the middle one lies `fromSample` beside the pixel: a gaussian, with a sum of 1.
vec3 gaussian(float fromSample, float sharpness) {
    float side = exp(-sharpness), ratio = exp(-2.0 * sharpness * fromSample);
    vec3 weights = vec3(side / ratio, 1.0, side * ratio);
    return weights / (weights.x + weights.y + weights.z);
}

void main() {
    // The sample nearest to this pixel, how far it lies from it, and both in pixels that are traced.
    vec2 place = (uv - frame.jitter.xy) * frame.targetSize.xy;
    ivec2 pixel = ivec2(place);
    vec2 fromSample = floor(place) + 0.5 - place;
    float upscale = frame.displaySize.x * frame.targetSize.z, sharpness = kSharpness * upscale * upscale;
    vec3 across = gaussian(fromSample.x, sharpness), up = gaussian(fromSample.y, sharpness);
    ivec2 high = ivec2(frame.targetSize.xy) - 1;
    vec3 sum = vec3(0.0), squares = vec3(0.0), now = vec3(0.0), low = vec3(1e9), top = vec3(-1e9);
    float depth = 1e9, surfaceShare = 1.0;
    float maxSurfaceShare = 0.0, frames = 0.0;
    ivec2 nearest = pixel, panePixel = pixel;
    for (int i = 0; i < 9; ++i) {
        ivec2 offset = ivec2(i % 3, i / 3) - 1;
        ivec2 p = clamp(pixel + offset, ivec2(0), high);
        vec4 there = texelFetch(uColor, p, 0);
        panePixel = there.a < surfaceShare ? p : panePixel;
        surfaceShare = min(surfaceShare, there.a);
        maxSurfaceShare = max(maxSurfaceShare, there.a);
        vec3 c = toYCoCg(compress(there.rgb));
        sum += c;
        squares += c * c;
        low = min(low, c);
        top = max(top, c);
        now += c * (across[i % 3] * up[i / 3]);
        if (i % 2 == 1) continue;  // corners and middle are enough to find an edge in front
        vec4 surface = texelFetch(uSurface, p, 0);
        // What changes is wider than a pixel: one that alone has no past shows what the others miss.
        frames = max(frames, floor(surface.z));
        if (surface.x < depth) {
            depth = surface.x;
            nearest = p;
        }
    }
    // Panes are never wholly seen through: where that changes may be the edge of one.
    float pane = uHasGlass ? texelFetch(uGlassSurface, panePixel, 0).w : 0.0;
    bool isPaneEdge = pane > 0.0 && pane < depth && maxSurfaceShare > 0.99;
    resolved = vec4(expand(fromYCoCg(now)), 0.0);
    // The motion of the nearest surface around, so that edges move with what is in front; the sky's by the camera alone. A pane moves
    // with what is behind it, but its edge with itself.
    vec2 motion = staticPointMotion(isPaneEdge ? (vec2(panePixel) + 0.5) * frame.targetSize.zw : uv, isPaneEdge ? pane : 4000.0);
    if (!isPaneEdge && depth < kSkyDepth) motion = texelFetch(uMotion, nearest, 0).rg;
    vec2 before = uv - motion;
    if (!uHistoryValid || any(lessThan(before, vec2(0.0))) || any(greaterThan(before, vec2(1.0)))) return;
    vec3 history = toYCoCg(compress(sampleHistory(before)));
    vec3 mean = sum / 9.0;
    vec3 deviation = sqrt(max(squares / 9.0 - mean * mean, vec3(0.0)));
    vec3 boxLow = max(low, mean - 1.25 * deviation), boxHigh = min(top, mean + 1.25 * deviation);
    if (depth >= kSkyDepth) frames = kLongHistory;
    bool isStatic = surfaceShare == 1.0 && length(motion * frame.targetSize.xy) < 0.05;
    float confidence = !isStatic ? 0.0 : uHasConfidence ? texture(uHistoryConfidence, uv).x : 1.0;
    float jitterDeviation = confidence * texelFetch(uHistory, ivec2(before * frame.displaySize.xy), 0).a;
    bool isConverged = isStatic && frames >= kLongHistory;
    vec3 middle = 0.5 * (boxLow + boxHigh), extent = 0.5 * (boxHigh - boxLow) * (isConverged ? kStaticClipScale : 1.0) + kJitterDeviations * jitterDeviation + 1e-4;
    vec3 offset = history - middle;
    vec3 ratio = abs(offset / extent);
    float outside = max(ratio.x, max(ratio.y, ratio.z));
    if (outside > 1.0) history = middle + offset / outside;
    resolved.a = confidence * mix(jitterDeviation, abs(now.x - history.x), kMinBlend);
    // Details finer than a pixel have no past as surfaces, but as pictures.
    if (jitterDeviation > kSubpixelDetail * history.x) frames = max(frames, float(min(frame.counters.x, 64)));
    float blend = clamp(kBlendRamp / (frames + kBlendRamp - 1.0), kMinBlend, kMaxBlend);
    float near = upscale > 1.0 ? exp(-0.5 * sharpness * dot(fromSample, fromSample)) : 1.0;
    resolved.rgb = expand(fromYCoCg(mix(history, now, near * mix(kParticleBlend, blend, surfaceShare))));
    resolved = stochasticRoundToHalf(resolved, ivec2(gl_FragCoord.xy), 0);
}
