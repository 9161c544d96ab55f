// The mean of what light_offset.frag has found, over tiles of the same surface, with Gaussian weights. It is noisy too,
// and so it is scaled by 1 - variance / mean^2: nothing is left of what may be noise alone, and nearly all of what is
// far above it, as by a Wiener filter.
#include "lib/constants.glsl"
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"

uniform sampler2D uOffset;

in vec2 uv;
out vec4 offset;  // rgb to be added to the history of light

const int kSide = 15, kTiles = 225;  // tiles
const float kNarrowness = 0.04;      // 1 / (2 deviations^2), of the Gaussian
const float kCaution = 0.5;          // of the variance: a little noise is seen less than a change that stays

/// How much a tile counts for one in the middle of `s`, at `position`.
float weightOf(ivec2 away, ivec2 pixel, Surface s, vec3 position) {
    Surface there = readSurface(pixel);
    vec3 ray = worldFromDepth((vec2(pixel) + 0.5) * frame.targetSize.zw, there.depth) - position;
    float onPlane = max(1.0 - abs(dot(ray, s.normal)) / (0.02 + 0.01 * s.depth), 0.0);
    float facing = dot(there.normal, s.normal) < 0.9 ? 0.0 : 1.0;
    return facing * onPlane * exp(-kNarrowness * float(away.x * away.x + away.y * away.y));
}

void main() {
    ivec2 tile = ivec2(gl_FragCoord.xy), high = ivec2(frame.targetSize.xy) - 1;
    ivec2 middle = min(tile * kConfidenceTile + 2, high);
    Surface s = readSurface(middle);
    vec3 position = worldFromDepth((vec2(middle) + 0.5) * frame.targetSize.zw, s.depth);
    vec3 sum = vec3(0.0);
    float squares = 0.0, weights = 0.0, weightSquares = 0.0;
    for (int i = 0; i < kTiles; ++i) {
        ivec2 away = ivec2(i % kSide, i / kSide) - kSide / 2, pixel = (tile + away) * kConfidenceTile + 2;
        if (pixel != clamp(pixel, ivec2(0), high)) continue;
        vec4 there = texelFetch(uOffset, tile + away, 0);
        float weight = weightOf(away, pixel, s, position) * there.a;
        vec3 mean = there.rgb / max(there.a, 1.0);
        sum += weight * mean;
        squares += weight * dot(mean, mean);
        weights += weight;
        weightSquares += weight * weight;
    }
    offset = vec4(0.0);
    if (weights <= 0.0) return;
    vec3 mean = sum / weights;
    float signal = dot(mean, mean);
    float variance = max(squares / weights - signal, 0.0) * weightSquares / (weights * weights);
    offset.rgb = mean * max(1.0 - kCaution * variance / max(signal, 1e-12), 0.0);
}
