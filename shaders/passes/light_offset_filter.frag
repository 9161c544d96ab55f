// The mean of what light_offset.frag has found, over tiles of the same surface.
#include "lib/constants.glsl"
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"

uniform sampler2D uOffset;

in vec2 uv;
out vec4 offset;

const int kReach = 7;  // tiles
const float kCaution = 0.5;

void main() {
    ivec2 tile = ivec2(gl_FragCoord.xy), high = ivec2(frame.targetSize.xy) - 1;
    ivec2 middle = min(tile * kConfidenceTile + 2, high);
    Surface s = readSurface(middle);
    vec3 position = worldFromDepth((vec2(middle) + 0.5) * frame.targetSize.zw, s.depth);
    vec4 sum = vec4(0.0);
    float squares = 0.0, weightSquares = 0.0;
    for (int y = -kReach; y <= kReach; ++y)
        for (int x = -kReach; x <= kReach; ++x) {
            ivec2 there = (tile + ivec2(x, y)) * kConfidenceTile + 2;
            if (there != clamp(there, ivec2(0), high)) continue;
            Surface other = readSurface(there);
            vec3 away = worldFromDepth((vec2(there) + 0.5) * frame.targetSize.zw, other.depth) - position;
            float near = max(1.0 - abs(dot(away, s.normal)) / (0.02 + 0.01 * s.depth), 0.0);
            if (dot(other.normal, s.normal) < 0.9) near = 0.0;
            vec4 tileSum = texelFetch(uOffset, tile + ivec2(x, y), 0);
            float weight = near * exp(-0.04 * float(x * x + y * y)) * tileSum.a;
            vec3 mean = tileSum.rgb / max(tileSum.a, 1.0);
            sum += weight * vec4(mean, 1.0);
            squares += weight * dot(mean, mean);
            weightSquares += weight * weight;
        }
    offset = vec4(0.0);
    if (sum.a <= 0.0) return;
    vec3 mean = sum.rgb / sum.a;
    float signal = dot(mean, mean), variance = max(squares / sum.a - signal, 0.0) * weightSquares / (sum.a * sum.a);
    offset = vec4(mean * max(1.0 - kCaution * variance / max(signal, 1e-12), 0.0), 1.0);
}
