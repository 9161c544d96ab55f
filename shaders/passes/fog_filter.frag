// A bilateral filter on the light of fog: 3x3 bilinear taps, each the mean of four texels, weighted by relative depth.
#include "lib/fog.glsl"

uniform sampler2D uLight;
uniform sampler2D uDepth;

in vec2 uv;
out vec4 filtered;

float depthAt(ivec2 halfPixel) {
    return texelFetch(uDepth, clamp(halfPixel * 2, ivec2(0), ivec2(frame.targetSize.xy) - 1), 0).r;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 texel = 1.0 / vec2(textureSize(uLight, 0));
    float depth = min(depthAt(pixel), kMaxFogDistance);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 9; ++i) {
        ivec2 offset = (ivec2(i % 3, i / 3) - 1) * 2;
        float there = min(depthAt(pixel + offset), kMaxFogDistance);
        float near = max(0.02, 1.0 - 3.0 * abs(there - depth) / max(there, depth));
        vec2 place = (vec2(pixel + offset) + (i == 4 ? 0.5 : 0.5 + 0.5 * sign(float(i - 4)))) * texel;
        sum += vec4(texture(uLight, place).rgb, 1.0) * near;
    }
    filtered = vec4(sum.rgb / sum.a, 1.0);
}
