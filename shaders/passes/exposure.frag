// Automatic exposure, in one texel: a factor on the level's exposure. As in Reinhard et al. 2002 the key of the image
// is its log-average luminance exp2(mean(log2 L)), here weighted toward the centre. The factor (target / key)^strength
// moves the key only partly to the target, as the eye adapts, and approaches it exponentially over time.
#include "lib/frame.glsl"
#include "lib/color.glsl"

uniform sampler2D uColor;
uniform sampler2D uHistory;
uniform bool uHistoryValid;
uniform float uSeconds;  // since the previous frame
uniform bool uIsFixed;   // the factor is 1

out vec4 exposure;

const ivec2 kTaps = ivec2(32, 18);
const float kTargetLuminance = 0.34;     // log-average luminance that needs no correction
const float kAdaptationStrength = 0.45;  // 1 would bring every image to the same key
const float kAdaptationRate = 3.078;     // per second: what is left falls to 1 / e in a third of one
const float kMinFactor = 0.7, kMaxFactor = 2.2;

void main() {
    exposure = vec4(1.0);
    if (uIsFixed) return;
    float sum = 0.0, total = 0.0;
    for (int y = 0; y < kTaps.y; ++y)
        for (int x = 0; x < kTaps.x; ++x) {
            vec2 place = (vec2(x, y) + 0.5) / vec2(kTaps);
            vec2 aside = place - 0.5;
            float w = exp(-3.0 * dot(aside, aside));
            sum += w * log2(clamp(luminance(texture(uColor, place).rgb) * frame.exposure.x, 0.01, 8.0));
            total += w;
        }
    float target = clamp(pow(kTargetLuminance / exp2(sum / total), kAdaptationStrength), kMinFactor, kMaxFactor);
    exposure =
        vec4(uHistoryValid ? mix(texelFetch(uHistory, ivec2(0), 0).r, target, 1.0 - exp(-kAdaptationRate * uSeconds))
                           : target);
}
