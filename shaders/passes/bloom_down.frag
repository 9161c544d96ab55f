// One step down the bloom pyramid: half the size, by four bilinear taps that together cover 4x4 texels of the source.
// The first step keeps only what is above the threshold.
uniform sampler2D uSource;
uniform vec2 uTexel;       // 1 / size of the source
uniform float uThreshold;  // radiance; 0 = keep all
in vec2 uv;
out vec4 result;

vec3 bright(vec2 place) {
    vec3 c = texture(uSource, place).rgb;
    float peak = max(c.r, max(c.g, c.b));
    // The limit keeps one very bright pixel from flickering over the whole image.
    return uThreshold > 0.0 ? min(c * max(peak - uThreshold, 0.0) / max(peak, 1e-4), vec3(12.0)) : c;
}

void main() {
    vec3 sum = bright(uv + uTexel * vec2(-0.9, -0.9)) + bright(uv + uTexel * vec2(0.9, -0.9)) +
               bright(uv + uTexel * vec2(-0.9, 0.9)) + bright(uv + uTexel * vec2(0.9, 0.9));
    result = vec4(sum * 0.25, 1.0);
}
