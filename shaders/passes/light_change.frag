// History confidence: finds where the light has changed, so that accumulate.frag may forget. A texel stands for a tile
// of 4x4 pixels. Two tests:
//   1. Statistics. A fast history (an exponential mean over 4 frames) is compared with the long one at the same
//      surfaces. Both are means of samples of one distribution as long as the light stays: their difference then has
//      the variance s^2 (1 / n_fast + 1 / n_long) / 16. Confidence falls from 1 at two to 0 at four standard
//      deviations. This is the idea of NVIDIA's ReLAX and ReBLUR ("fast history") and of A-SVGF (Schied et al. 2018).
//      The 16 samples of this frame alone are compared too, as a large change must not take four frames to be seen.
//   2. Knowledge (lib/known_changes.glsl), at each of the 16 pixels, so that no edge of a surface is missed.
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "lib/known_changes.glsl"
#include "lib/surface_history.glsl"

uniform sampler2D uLight;
uniform sampler2D uMotion;
uniform sampler2D uLightHistory;    // accumulated light
uniform sampler2D uSurfaceHistory;  // lib/surface_history.glsl
uniform sampler2D uFastHistory;
uniform bool uHistoryValid;
uniform sampler2D uDepth;
uniform bool uHasGlass;
uniform sampler2D uChangedLight;  // passes/changed_lights.frag
uniform bool uHasChangedLight;
uniform sampler2D uLightOffset;  // passes/light_offset.frag
uniform bool uHasLightOffset;

const float kFastHistoryFrames = 4.0;
const float kOneFrameScale = 0.3;   // of one frame's difference: it must be many deviations, as 16 samples are few
const float kMaxLuminance = 250.0;  // a half float holds its square

// x mean luminance, y variance of a sample, z mean share of the sun, w frames.
layout(location = 0) out vec4 fastHistory;
// 1 keeps the history, 0 drops it: x by statistics, y by knowledge of light; z the most that anti-aliasing keeps.
layout(location = 1) out vec4 confidence;

float confidenceOf(float difference, float deviation) {
    return 1.0 - smoothstep(2.0, 4.0, abs(difference) / deviation);
}

/// Luminance of all light that a place had: by the history of light, and the sun by the surface that it shone on.
float lastRadiance(vec2 lastUv) {
    vec4 light = texture(uLightHistory, lastUv);
    float packed_ = texelFetch(uSurfaceHistory, ivec2(lastUv * frame.targetSize.xy), 0).y;
    float facing = packed_ < 0.0 ? 0.0 : max(dot(unpackNormal(packed_), frame.sunDirection.xyz), 0.0);
    return luminance(light.rgb + frame.sunColor.rgb * (light.a * facing / kPi));
}

/// Whether something nearer was seen in the previous frame at pixel i of a tile or at the one beside it outward.
bool isUncovered(ivec2 pixel, int i, vec3 position, ivec2 high) {
    ivec2 last = pixel - ivec2(round(texelFetch(uMotion, pixel, 0).rg * frame.targetSize.xy));
    ivec2 outward = ivec2((i & 3) < 2 ? -1 : 1, i < 8 ? -1 : 1);
    float before = min(texelFetch(uSurfaceHistory, clamp(last, ivec2(0), high), 0).x,
                       texelFetch(uSurfaceHistory, clamp(last + outward, ivec2(0), high), 0).x);
    return before < 0.97 * previousDepth(position) - 0.05;
}

/// The least history that is left to any pixel of a tile. meanRadiance: of the light that the tile had.
float historyLeftIn(ivec2 tile, ivec2 high, float meanRadiance) {
    float left = historyLeftAfter(uLateSkylightChange);
    int i = loopBegin();
    do {
        if (uDirtyCornerCount + uChangedLightTexels + uLookCornerCount == 0) break;
        ivec2 p = min(tile + ivec2(i & 3, i >> 2), high);
        vec3 position = worldFromDepth((vec2(p) + 0.5) * frame.targetSize.zw, texelFetch(uDepth, p, 0).r);
        left = min(left, historyLeftAt(position, meanRadiance));
        if ((uHasGlass || isUncovered(p, i, position, high)) && isSeenThroughChange(position)) left = 0.0;
        if (isSunSeenThroughChange(position)) left = 0.0;
    } while (++i < 16);
    return left;
}

/// The least share of colours' history that is left to any pixel of a tile or beside it.
float colorsLeftIn(ivec2 tile, ivec2 high) {
    float share = uLookEverywhere;
    int i = loopBegin();
    do {
        if (uLookCornerCount == 0) break;
        ivec2 p = clamp(tile + ivec2(i % 6, i / 6) - 1, ivec2(0), high);
        vec3 position = worldFromDepth((vec2(p) + 0.5) * frame.targetSize.zw, texelFetch(uDepth, p, 0).r);
        share = max(share, newShareAt(position, uHasGlass));
    } while (++i < 36);
    return 1.0 - share;
}

/// Mean luminance that is known to have been added to a tile's light.
float changedLuminance(ivec2 tile, ivec2 high) {
    float sum = uHasLightOffset ? luminance(texelFetch(uLightOffset, ivec2(gl_FragCoord.xy), 0).rgb) : 0.0;
    int i = loopBegin();
    do {
        if (!uHasChangedLight) break;
        sum += luminance(texelFetch(uChangedLight, min(tile + ivec2(i & 3, i >> 2), high), 0).rgb) / 16.0;
    } while (++i < 16);
    return sum;
}

void main() {
    ivec2 tile = ivec2(gl_FragCoord.xy) * kConfidenceTile, high = ivec2(frame.targetSize.xy) - 1;
    vec3 now = vec3(0.0);
    for (int i = 0; i < 16; ++i) {
        vec4 light = texelFetch(uLight, min(tile + ivec2(i & 3, i >> 2), high), 0);
        float l = min(luminance(light.rgb), kMaxLuminance);
        now += vec3(l, l * l, light.a);
    }
    now /= 16.0;
    now.y = max(now.y - now.x * now.x, 0.0);
    fastHistory = vec4(now, 1.0);
    confidence = vec4(1.0);
    if (!uHistoryValid) return;
    ivec2 middle = min(tile + 2, high);
    vec2 lastUv = (vec2(tile) + 2.0) * frame.targetSize.zw - texelFetch(uMotion, middle, 0).rg;
    confidence.y = historyLeftIn(tile, high, lastRadiance(lastUv));
    confidence.z = colorsLeftIn(tile, high);
    if (any(lessThan(lastUv, vec2(0.0))) || any(greaterThanEqual(lastUv, vec2(1.0)))) return;
    vec4 lastFastHistory = texture(uFastHistory, lastUv);
    float changed = changedLuminance(tile, high);
    lastFastHistory.x = max(lastFastHistory.x + changed, 0.0);
    float fastFrames = min(lastFastHistory.w + 1.0, kFastHistoryFrames);
    fastHistory = vec4(mix(lastFastHistory.xyz, now, 1.0 / fastFrames), fastFrames);

    vec4 history = vec4(0.0);
    for (int i = 0; i < 4; ++i)
        history += texture(uLightHistory, lastUv + vec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1) * frame.targetSize.zw);
    history *= 0.25;
    vec2 surface = texture(uSurfaceHistory, lastUv).zw;
    float historyLum = max(luminance(history.rgb) + changed, 0.0), frames = max(surface.x, 1.0);
    float share = (1.0 / fastFrames + 1.0 / frames) / 16.0;
    float sunVariance = max(history.a * (1.0 - history.a), fastHistory.z * (1.0 - fastHistory.z)) + 0.02;
    float variance = max(now.y, surface.y - historyLum * historyLum);
    confidence.x = confidenceOf(kOneFrameScale * (now.x - historyLum), sqrt(variance / 16.0) + 0.1 * historyLum + 1e-4);
    confidence.x =
        min(confidence.x,
            min(confidenceOf(fastHistory.x - historyLum, sqrt(fastHistory.y * share) + 0.03 * fastHistory.x + 1e-4),
                confidenceOf(fastHistory.z - history.a, sqrt(sunVariance * share))));
    if (min(confidence.x, confidence.y) < 0.5)
        fastHistory = vec4(now, 1.0);  // the old light must not count in the fast history either
}
