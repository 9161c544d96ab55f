// Temporal accumulation of light (reprojection; as in SVGF, Schied et al. 2017). The light of this frame is mixed with
// the history of the same place of the world:
//   L' = mix(H, L, blend),   H = bilinear mean of the previous frame's four pixels at uv - motion
// A tap counts only if it lies on the same surface: its depth must be what this place had in the previous frame and its
// normal must agree; else it was hidden then (disocclusion). With n frames of history a mean has blend = 1 / n. Here it
// is (1 + 1 / n) / n, which lets the first frames count less, as they know less of bounced light. n is limited by
// uMaxHistory, by the history confidence (passes/light_change.frag) and by what is known to have changed
// (passes/history_left.frag): there history is dropped, and more rays are sent (lib/change_rays.glsl). The second
// moment of luminance is accumulated likewise, for the filter's variance.
//
// The sun's share changes far from the voxels that move: where their shadow falls. There it is kept between the least
// and the most that the pixel and its neighbours see of the sun now (as Lottes clamps colours, "TSSAA", 2011): out of
// penumbras they agree, and the shadow is where it is now.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/half.glsl"
#include "lib/color.glsl"
#include "lib/surface_history.glsl"
#include "lib/history_left.glsl"

uniform sampler2D uLight;
uniform sampler2D uHitProximity;
uniform bool uHasHitProximity;
uniform sampler2D uLightHistory;
uniform sampler2D uSurfaceHistory;
uniform sampler2D uHistoryConfidence;
uniform bool uHasConfidence;
uniform bool uHistoryValid;
uniform sampler2D uChangedLight;  // passes/changed_lights.frag
uniform bool uHasChangedLight;
uniform sampler2D uLightOffset;  // passes/light_offset.frag
uniform bool uHasLightOffset;
uniform float uNewSunShare;  // of this frame in the mean of the sun's visibility, at the least: the sun has turned

in vec2 uv;
layout(location = 0) out vec4 accumulated;
layout(location = 1) out vec4 surface;

const float kMaxProximity = 0.99;  // it is stored as a fraction

struct History {
    vec4 light;
    float frames;
    float secondMoment;
    float hitProximity;
    float weight;
};

/// The history of a place, interpolated between those of four pixels that show the same surface. Weight 0: none does.
History reprojectHistory(Surface s, float packed_, vec3 position) {
    History history = History(vec4(0.0), 0.0, 0.0, 0.0, 0.0);
    vec2 lastUv = uv - texelFetch(uMotion, ivec2(gl_FragCoord.xy), 0).rg;
    if (!uHistoryValid || any(lessThan(lastUv, vec2(0.0))) || any(greaterThanEqual(lastUv, vec2(1.0)))) return history;
    float expected = previousDepth(position);
    float tolerance = depthTolerance(position, s.normal, s.depth) + s.moving * 0.5;
    Taps taps = tapsAt(lastUv);
    int i = loopBegin();
    do {
        ivec2 p;
        float w = tapWeight(taps, i, p);
        vec4 there = texelFetch(uSurfaceHistory, p, 0);
        if (abs(there.x - expected) <= tolerance &&
            (there.y == packed_ || dot(unpackNormal(there.y), s.normal) >= 0.9)) {
            history.light += w * texelFetch(uLightHistory, p, 0);
            history.frames += w * floor(there.z);
            history.hitProximity += w * fract(there.z);
            history.secondMoment += w * max(there.w, 0.0);
            history.weight += w;
        }
    } while (++i < taps.count);
    if (history.weight < 0.01) {
        history.weight = 0.0;
        return history;
    }
    history.light /= history.weight;
    history.frames /= history.weight;
    history.hitProximity /= history.weight;
    history.secondMoment /= history.weight;
    return history;
}

/// A past share of the sun, within what `neighbours` pixels see of it now: the 9 around, or none to keep it.
float clampToNeighbours(float sun, ivec2 pixel, int neighbours) {
    float least = neighbours > 0 ? 1.0 : 0.0, most = 1.0 - least;
    int i = 0;
    do {
        if (neighbours == 0) break;
        ivec2 p = clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), ivec2(frame.targetSize.xy) - 1);
        float there = texelFetch(uLight, p, 0).a;
        least = min(least, there);
        most = max(most, there);
    } while (++i < neighbours);
    return clamp(sun, least, most);
}

/// Makes the history of a pixel that of the lights of this frame. Its variance stays, as nothing says how much of it
/// came from the lights that changed: where one has gone, the filter takes the light for noisier than it is.
void relight(inout History history, ivec2 pixel) {
    float before = luminance(history.light.rgb);
    if (uHasChangedLight)
        history.light.rgb = max(history.light.rgb + texelFetch(uChangedLight, pixel, 0).rgb, vec3(0.0));
    if (uHasLightOffset) history.light.rgb = max(history.light.rgb + texture(uLightOffset, uv).rgb, vec3(0.0));
    float now = luminance(history.light.rgb);
    history.secondMoment = max(history.secondMoment - before * before, 0.0) + now * now;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    vec4 now = halfRange(texelFetch(uLight, pixel, 0));  // a sum of passes
    float lum = luminance(now.rgb);
    accumulated = now;
    float hitProximity = uHasHitProximity ? min(texelFetch(uHitProximity, pixel, 0).x, kMaxProximity) : 0.0;
    surface = vec4(s.depth, packNormal(s.normal), 1.0 + hitProximity, s.emission > 0.0 ? -1.0 : lum * lum);
    History history = reprojectHistory(s, surface.y, worldFromDepth(uv, s.depth));
    if (history.weight == 0.0) return;
    if (uHasChangedLight || uHasLightOffset) relight(history, pixel);
    HistoryLeft left = historyLeftOf(ivec2((uv - texelFetch(uMotion, pixel, 0).rg) * frame.targetSize.xy));
    history.light.a = clampToNeighbours(history.light.a, pixel, left.sunChanged ? 9 : 0);  // a loop costs no lookups
    float confidence = uHasConfidence ? min(texture(uHistoryConfidence, uv).x, left.lately) : 1.0;
    float added = float(left.rays), frames = min(min(history.frames, confidence * uMaxHistory) + added, uMaxHistory);
    // Where the second frame of a change starts again there is no third one.
    if (left.lately < kDropped && history.frames < kSettledFrames) frames = min(frames, float(kRaysAfterChange) - 1.0);
    float blend = min((1.0 + 1.0 / frames) * added / frames, 1.0);
    vec4 blends = vec4(vec3(blend), max(blend, uNewSunShare));
    accumulated = stochasticRoundToHalf(mix(history.light, now, blends), pixel, 0);
    surface.z = floor(frames + 0.01) + min(mix(history.hitProximity, hitProximity, blend), kMaxProximity);
    surface.w = s.emission > 0.0 ? -1.0 : mix(history.secondMoment, lum * lum, blend);
}
