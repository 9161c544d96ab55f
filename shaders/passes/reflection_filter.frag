// One pass of an edge-avoiding a-trous filter on reflections: see passes/filter.frag. A glossy surface shows the
// mirrored world blurred by its lobe, sharp where something touches it and the softer the farther it is. A tap counts
// by how far into that blur it lies: the radius shrinks with roughness and with the distance to what is mirrored
// (passes/reflection_accumulate.frag), so that contacts stay sharp.
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "lib/noise.glsl"
#include "lib/half.glsl"
#include "lib/surface_history.glsl"
#include "lib/atrous.glsl"

uniform sampler2D uReflection;  // rgb radiance, a frames of history or those times -1
uniform sampler2D uMoments;     // x mean squared luminance, y radius of the lobe's blur, pixels
uniform sampler2D uSurface;     // lib/surface_history.glsl
uniform int uStride;            // pixels
uniform bool uDiagonal;
uniform bool uIsLast;  // alpha becomes 1

in vec2 uv;
out vec4 filtered;

const int kTaps = 5;  // the first is the pixel itself
const float kCentreWeight = 1.5;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), high = ivec2(frame.targetSize.xy) - 1;
    vec4 centre = texelFetch(uReflection, pixel, 0);
    vec2 centreMoments = texelFetch(uMoments, pixel, 0).xy;
    filtered = centre;
    float radius = centreMoments.y;
    if (uStride > 0 && radius > 0.5 * float(uStride)) {
        vec4 surface = texelFetch(uSurface, pixel, 0);
        Plane plane = planeOf(uv, surface);
        vec4 taps[kTaps];
        float weights[kTaps];
        float total = 0.0, lum = 0.0, squares = 0.0, temporal = 0.0;
        for (int i = 0; i < kTaps; ++i) {
            ivec2 away = tapOffset(i, uDiagonal) * uStride, p = clamp(pixel + away, ivec2(0), high);
            vec4 there = texelFetch(uSurface, p, 0), light = texelFetch(uReflection, p, 0);
            vec2 m = texelFetch(uMoments, p, 0).xy;
            float w = i == 0 ? kCentreWeight
                      : light.a != 0.0 && there.y == surface.y
                          ? planeWeight(plane, vec2(p - pixel), there.x) *
                                max(0.0, 1.0 - length(vec2(away)) / (2.0 * min(radius, m.y) + 1e-3))
                          : 0.0;
            float l = luminance(light.rgb);
            taps[i] = light;
            weights[i] = w;
            lum += w * l;
            squares += w * l * l;
            temporal += w * max(m.x - l * l, 0.0) / max(abs(light.a), 1.0);
            total += w;
        }
        lum /= total;
        float spatial = max(squares / total - lum * lum, 0.0);
        float deviation = sqrt(mix(spatial, temporal / total, clamp((abs(centre.a) - 3.0) / 6.0, 0.0, 1.0)));
        float share = 2.0 * deviation / max(lum, 1e-5) + 0.025, centreLum = luminance(centre.rgb);
        for (int i = 1; i < kTaps; ++i) {
            float l = luminance(taps[i].rgb), w = weights[i] / (kCentreWeight + float(kTaps - 1));
            filtered.rgb +=
                (taps[i].rgb - centre.rgb) * (w * biweight((l - centreLum) / (share * (l + centreLum) + 1e-4)));
        }
        filtered.rgb = stochasticRoundToHalf(vec4(filtered.rgb, 0.0), pixel, 8 + uStride).rgb;
    }
    if (uIsLast) filtered.a = 1.0;
}
