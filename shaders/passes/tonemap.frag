// Radiance to display: exposure, bloom, a film curve, a slight vignette, and dither against bands in skies: the sum of
// two blue-noise numbers has a triangular distribution, which decouples the rounding error from the signal.
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/color.glsl"

uniform sampler2D uColor;
uniform sampler2D uBloom;
uniform float uBloomShare;
uniform sampler2D uExposure;
uniform float uSharpen;

in vec2 uv;
out vec4 color;

/// A fit of the ACES film curve (Narkowicz 2015) with a lighter toe, so that shadows keep their colour.
vec3 filmCurve(vec3 x) { return clamp((x * (2.51 * x + 0.05)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }

/// Raises the contrast to the four neighbours, limited to their range, so that edges get no halo.
vec3 sharpen(ivec2 p) {
    ivec2 high = ivec2(frame.displaySize.xy) - 1;
    vec3 centre = texelFetch(uColor, p, 0).rgb;
    vec3 a = texelFetch(uColor, max(p - ivec2(1, 0), ivec2(0)), 0).rgb,
         b = texelFetch(uColor, min(p + ivec2(1, 0), high), 0).rgb;
    vec3 c = texelFetch(uColor, max(p - ivec2(0, 1), ivec2(0)), 0).rgb,
         d = texelFetch(uColor, min(p + ivec2(0, 1), high), 0).rgb;
    vec3 low = min(centre, min(min(a, b), min(c, d))), top = max(centre, max(max(a, b), max(c, d)));
    return clamp(centre + (centre - (a + b + c + d) * 0.25) * uSharpen, low, top);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 c = sharpen(pixel);
    if (uBloomShare > 0.0) c += texture(uBloom, uv).rgb * uBloomShare;
    c *= frame.exposure.x * texelFetch(uExposure, ivec2(0), 0).r;
    vec2 aside = (uv - 0.5) * vec2(1.0, 0.8);
    float r2 = dot(aside, aside);
    c *= 1.0 - 0.5 * r2 * r2 - 0.12 * r2;
    // With the factor 0.5 and exposure 1 a white wall in the default evening sun has three quarters of display white.
    c = linearToSrgb(filmCurve(c * 0.5));
    vec2 noise = blueNoise(pixel, 40, frame.counters.x);
    color = vec4(c + (noise.x + noise.y - 1.0) / 255.0, 1.0);
}
