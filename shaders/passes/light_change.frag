// Where light has changed: each texel stands for 4x4 pixels and compares what has reached them in the last few fastFrames with
// what they remember. Both see the same surfaces, so what differs is noise or a change. Read by accumulate.frag.
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "shared/constants.h"

uniform sampler2D uLight;
uniform sampler2D uMotion;
uniform sampler2D uLightHistory;     // accumulated
uniform sampler2D uSurfaceHistory;   // z frames accumulated
uniform sampler2D uFastHistory;
uniform bool uHistoryValid;
uniform sampler2D uDepth;
uniform int uDirtyCornerCount;  // corners of boxes, low and high by turns, where what casts shadows has changed since the last picture
uniform vec4 uDirtyCorners[2 * kMaxDirtyRegions];   // of these, world

const float kFastHistoryFrames = 4.0;  // fastFrames that the short memory holds

layout(location = 0) out vec4 fastHistory;    // of the last few fastFrames: mean luminance, its variance a sample, mean share of the sun; fastFrames
layout(location = 1) out vec4 confidence;  // x: 1 where memory holds, 0 where it must be forgotten

float confidenceOf(float difference, float deviation) { return 1.0 - smoothstep(2.0, 4.0, abs(difference) / deviation); }

const float kResetDistance = 1.2;  // metres from what changed within which all is forgotten
const float kKeepDistance = 4.0;  // beyond which only what is seen to differ is

/// What may be confidence of the memory of a place when something near it has changed.
float confidenceNear(vec3 position) {
    float nearest = kKeepDistance;
    for (int i = 0; i < uDirtyCornerCount; i += 2)
        nearest = min(nearest, length(max(max(uDirtyCorners[i].xyz - position, position - uDirtyCorners[i + 1].xyz), vec3(0.0))));
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
    for (int i = 0; i < 4; ++i) history += texture(uLightHistory, lastUv + vec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1) * frame.targetSize.zw);
    history *= 0.25;
    float historyLum = luminance(history.rgb), frames = max(texture(uSurfaceHistory, lastUv).z, 1.0);
    // What a mean of that many samples strays by, here and in the memory.
    float share = (1.0 / fastFrames + 1.0 / frames) / 16.0;
    float sunVariance = max(history.a * (1.0 - history.a), fastHistory.z * (1.0 - fastHistory.z)) + 0.02;
    confidence.x = min(confidenceOf(fastHistory.x - historyLum, sqrt(fastHistory.y * share) + 0.03 * fastHistory.x + 1e-4), confidenceOf(fastHistory.z - history.a, sqrt(sunVariance * share)));
    ivec2 middle = min(tile + 2, high);
    confidence.x = min(confidence.x, confidenceNear(worldFromDepth((vec2(middle) + 0.5) * frame.targetSize.zw, texelFetch(uDepth, middle, 0).r)));
    if (confidence.x < 0.5) fastHistory = vec4(now, 1.0);  // what is new is all that counts from here on
}
