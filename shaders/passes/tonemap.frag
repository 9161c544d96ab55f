// Radiance to display: exposure, bloom, a film curve, a slight vignette, and dither against bands in skies: the sum of
// two blue-noise numbers has a triangular distribution, which decouples the rounding error from the signal.
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/color.glsl"
#include "lib/display.glsl"

uniform sampler2D uColor;
uniform sampler2D uBloom;
uniform float uBloomShare;
uniform sampler2D uExposure;
uniform float uSharpen;

in vec2 uv;
out vec4 color;

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
    c = toDisplay(c, uv);
    vec2 noise = blueNoise(pixel, 40, frame.counters.x);
    color = vec4(c + (noise.x + noise.y - 1.0) / 255.0, 1.0);
}
