// History confidence: finds where the light has changed, so that accumulate.frag may forget. A texel stands for a tile
// of 4x4 pixels. Two tests, and the stricter one counts:
//   1. Statistics. A fast history (an exponential mean over 4 frames) is compared with the long one at the same
//      surfaces. Both are means of samples of one distribution as long as the light stays: their difference then has
//      the variance s^2 (1 / n_fast + 1 / n_long) / 16. Confidence falls from 1 at two to 0 at four standard
//      deviations. This is the idea of NVIDIA's ReLAX and ReBLUR ("fast history") and of A-SVGF (Schied et al. 2018).
//   2. Geometry. Around what the engine knows to have changed (dirty regions) the confidence is lowered by distance.
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/color.glsl"

uniform sampler2D uLight;
uniform sampler2D uMotion;
uniform sampler2D uLightHistory;    // accumulated light
uniform sampler2D uSurfaceHistory;  // z frames accumulated
uniform sampler2D uFastHistory;
uniform bool uHistoryValid;
uniform sampler2D uDepth;
uniform int uDirtyCornerCount;
uniform vec4 uDirtyCorners[2 * kMaxDirtyRegions];  // low and high corners of changed boxes by turns, world

const float kFastHistoryFrames = 4.0;
const float kResetDistance = 1.2;  // metres around a change within which all history is dropped
const float kKeepDistance = 4.0;   // metres beyond which only the statistics count

// x mean luminance, y variance of a sample, z mean share of the sun, w frames.
layout(location = 0) out vec4 fastHistory;
layout(location = 1) out vec4 confidence;  // x: 1 keeps the history, 0 drops it

float confidenceOf(float difference, float deviation) {
    return 1.0 - smoothstep(2.0, 4.0, abs(difference) / deviation);
}

/// The geometric test.
float confidenceNear(vec3 position) {
    float nearest = kKeepDistance;
    for (int i = 0; i < uDirtyCornerCount; i += 2)
        nearest = min(
            nearest, length(max(max(uDirtyCorners[i].xyz - position, position - uDirtyCorners[i + 1].xyz), vec3(0.0))));
    return max(nearest - kResetDistance, 0.0) / (kKeepDistance - kResetDistance);
}

void main() {
    ivec2 tile = ivec2(gl_FragCoord.xy) * kConfidenceTile, high = ivec2(frame.targetSize.xy) - 1;
    vec3 now = vec3(0.0);
    for (int i = 0; i < 16; ++i) {
        vec4 light = texelFetch(uLight, min(tile + ivec2(i & 3, i >> 2), high), 0);
        float l = luminance(light.rgb);
        now += vec3(l, l * l, light.a);
    }
    now /= 16.0;
    now.y = max(now.y - now.x * now.x, 0.0);
    fastHistory = vec4(now, 1.0);
    confidence = vec4(1.0);
    if (!uHistoryValid) return;
    vec2 lastUv = (vec2(tile) + 2.0) * frame.targetSize.zw - texelFetch(uMotion, min(tile + 2, high), 0).rg;
    if (any(lessThan(lastUv, vec2(0.0))) || any(greaterThanEqual(lastUv, vec2(1.0)))) return;
    vec4 lastFastHistory = texture(uFastHistory, lastUv);
    float fastFrames = min(lastFastHistory.w + 1.0, kFastHistoryFrames);
    fastHistory = vec4(mix(lastFastHistory.xyz, now, 1.0 / fastFrames), fastFrames);

    vec4 history = vec4(0.0);
    for (int i = 0; i < 4; ++i)
        history += texture(uLightHistory, lastUv + vec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1) * frame.targetSize.zw);
    history *= 0.25;
    float historyLum = luminance(history.rgb), frames = max(texture(uSurfaceHistory, lastUv).z, 1.0);
    float share = (1.0 / fastFrames + 1.0 / frames) / 16.0;
    float sunVariance = max(history.a * (1.0 - history.a), fastHistory.z * (1.0 - fastHistory.z)) + 0.02;
    confidence.x =
        min(confidenceOf(fastHistory.x - historyLum, sqrt(fastHistory.y * share) + 0.03 * fastHistory.x + 1e-4),
            confidenceOf(fastHistory.z - history.a, sqrt(sunVariance * share)));
    ivec2 middle = min(tile + 2, high);
    confidence.x = min(confidence.x, confidenceNear(worldFromDepth((vec2(middle) + 0.5) * frame.targetSize.zw,
                                                                   texelFetch(uDepth, middle, 0).r)));
    if (confidence.x < 0.5) fastHistory = vec4(now, 1.0);  // the old light must not count in the fast history either
}
