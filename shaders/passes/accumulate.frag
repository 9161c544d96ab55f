// Temporal accumulation of light (reprojection; as in SVGF, Schied et al. 2017). The light of this frame is mixed with
// the history of the same place of the world:
//   L' = mix(H, L, blend),   H = bilinear mean of the previous frame's four pixels at uv - motion
// A tap counts only if it lies on the same surface: its depth must be what this place had in the previous frame and its
// normal must agree; else it was hidden then (disocclusion). With n frames of history a mean has blend = 1 / n. Here it
// is (1 + 1 / n) / n, which lets the first frames count less, as they know less of bounced light. n is limited by
// uMaxHistory, by the history confidence (passes/light_change.frag) and by what is known to have changed
// (lib/known_changes.glsl): there history is dropped, and more rays are sent (lib/change_rays.glsl). The second moment
// of luminance is accumulated likewise, for the filter's variance.
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
#include "lib/known_changes.glsl"
#include "lib/change_rays.glsl"

uniform sampler2D uLight;
uniform sampler2D uHitProximity;
uniform bool uHasHitProximity;
uniform sampler2D uLightHistory;
uniform sampler2D uSurfaceHistory;
uniform sampler2D uHistoryConfidence;
uniform bool uHasConfidence;
uniform bool uHistoryValid;

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
    vec2 corner = lastUv * frame.targetSize.xy - 0.5;
    ivec2 base = ivec2(floor(corner));
    vec2 f = corner - vec2(base);
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        float w = (offset.x == 1 ? f.x : 1.0 - f.x) * (offset.y == 1 ? f.y : 1.0 - f.y);
        if (w < 0.004) continue;  // one tap is enough where the camera stands still
        ivec2 p = clamp(base + offset, ivec2(0), ivec2(frame.targetSize.xy) - 1);
        vec4 there = texelFetch(uSurfaceHistory, p, 0);
        if (abs(there.x - expected) > tolerance || (there.y != packed_ && dot(unpackNormal(there.y), s.normal) < 0.9))
            continue;
        history.light += w * texelFetch(uLightHistory, p, 0);
        history.frames += w * floor(there.z);
        history.hitProximity += w * fract(there.z);
        history.secondMoment += w * max(there.w, 0.0);
        history.weight += w;
    }
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

/// A past share of the sun, within what the neighbours see of it now.
float clampToNeighbours(float sun, ivec2 pixel) {
    float least = 1.0, most = 0.0;
    for (int i = 0; i < 9; ++i) {
        ivec2 p = clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), ivec2(frame.targetSize.xy) - 1);
        float there = texelFetch(uLight, p, 0).a;
        least = min(least, there);
        most = max(most, there);
    }
    return clamp(sun, least, most);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    vec4 now = halfRange(texelFetch(uLight, pixel, 0));  // a sum of passes
    float lum = luminance(now.rgb);
    accumulated = now;
    float hitProximity = uHasHitProximity ? min(texelFetch(uHitProximity, pixel, 0).x, kMaxProximity) : 0.0;
    surface = vec4(s.depth, packNormal(s.normal), 1.0 + hitProximity, s.emission > 0.0 ? -1.0 : lum * lum);
    vec3 position = worldFromDepth(uv, s.depth);
    History history = reprojectHistory(s, surface.y, position);
    if (history.weight == 0.0) return;
    float left = 1.0, confidence = 1.0;
    int rays = 1;
    if (uHasConfidence && isSunSeenThroughChange(position)) history.light.a = clampToNeighbours(history.light.a, pixel);
    if (uHasConfidence) {
        left = historyLeftAt(position, luminance(history.light.rgb));
        confidence = min(texture(uHistoryConfidence, uv).x, left);
        rays = raysAt(floor(history.frames + 0.01), left, uv - texelFetch(uMotion, pixel, 0).rg);
    }
    float added = float(rays), frames = min(min(history.frames, confidence * uMaxHistory) + added, uMaxHistory);
    // Where the second frame of a change starts again there is no third one.
    if (left < kDropped && history.frames < kSettledFrames) frames = min(frames, float(kRaysAfterChange) - 1.0);
    float blend = min((1.0 + 1.0 / frames) * added / frames, 1.0);
    accumulated = stochasticRoundToHalf(mix(history.light, now, blend), pixel, 0);
    surface.z = floor(frames + 0.01) + min(mix(history.hitProximity, hitProximity, blend), kMaxProximity);
    surface.w = s.emission > 0.0 ? -1.0 : mix(history.secondMoment, lum * lum, blend);
}
