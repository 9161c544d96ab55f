// One texel: how much brighter or darker than the level's exposure the picture is shown. The eye adapts slowly and only in part.
#include "lib/frame.glsl"
#include "lib/color.glsl"

uniform sampler2D uColor;
uniform sampler2D uHistory;
uniform bool uHistoryValid;

out vec4 exposure;

const ivec2 kTaps = ivec2(32, 18);
const float kTargetLuminance = 0.34;     // mean luminance that needs no correction
const float kAdaptationStrength = 0.45;   // of the adaptation: 1 would bring every picture to the same mean
const float kAdaptationSpeed = 0.05;      // a frame

void main() {
    float sum = 0.0, total = 0.0;
    for (int y = 0; y < kTaps.y; ++y)
        for (int x = 0; x < kTaps.x; ++x) {
            vec2 place = (vec2(x, y) + 0.5) / vec2(kTaps);
            vec2 aside = place - 0.5;
            float w = exp(-3.0 * dot(aside, aside));
            sum += w * log2(clamp(luminance(texture(uColor, place).rgb) * frame.exposure.x, 0.01, 8.0));
            total += w;
        }
    float target = clamp(pow(kTargetLuminance / exp2(sum / total), kAdaptationStrength), 0.7, 2.2);
    exposure = vec4(uHistoryValid ? mix(texelFetch(uHistory, ivec2(0), 0).r, target, kAdaptationSpeed) : target);
}
