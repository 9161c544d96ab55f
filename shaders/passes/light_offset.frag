// How far the history of light lies off the light of now: the mean over a tile of kConfidenceTile x kConfidenceTile
// pixels of the difference between this frame's light and the history (without the changes that changed_lights.frag
// knows). One pixel's difference is all noise, but what is left of a change, light that came by bounces, varies slowly
// over a surface; light_offset_filter.frag takes the mean of many tiles. Temporal accumulation adds it to the history.
#include "lib/constants.glsl"
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/half.glsl"
#include "lib/color.glsl"
#include "lib/surface_history.glsl"

uniform sampler2D uLight;
uniform sampler2D uLightHistory;
uniform sampler2D uSurfaceHistory;
uniform sampler2D uChangedLight;
uniform bool uHasChangedLight;

in vec2 uv;
out vec4 offset;  // rgb sum, a number of pixels that count

const float kMaxLuminance = 64.0;

/// a: 1 where the pixel has a history.
vec4 offsetOf(ivec2 pixel) {
    Surface s = readSurface(pixel);
    vec2 place = (vec2(pixel) + 0.5) * frame.targetSize.zw;
    vec2 lastUv = place - texelFetch(uMotion, pixel, 0).rg;
    if (!s.lit || any(lessThan(lastUv, vec2(0.0))) || any(greaterThanEqual(lastUv, vec2(1.0)))) return vec4(0.0);
    ivec2 last = ivec2(lastUv * frame.targetSize.xy);
    vec4 surface = texelFetch(uSurfaceHistory, last, 0);
    vec3 position = worldFromDepth(place, s.depth);
    if (abs(surface.x - previousDepth(position)) > depthTolerance(position, s.normal, s.depth)) return vec4(0.0);
    vec3 history = texelFetch(uLightHistory, last, 0).rgb;
    if (uHasChangedLight) history = max(history + texelFetch(uChangedLight, pixel, 0).rgb, vec3(0.0));
    vec3 now = halfRange(texelFetch(uLight, pixel, 0)).rgb;
    return vec4(now * min(1.0, kMaxLuminance / max(luminance(now), 1e-6)) - history, 1.0);
}

void main() {
    ivec2 tile = ivec2(gl_FragCoord.xy) * kConfidenceTile, high = ivec2(frame.targetSize.xy) - 1;
    offset = vec4(0.0);
    for (int i = 0; i < 16; ++i) offset += offsetOf(min(tile + ivec2(i & 3, i >> 2), high));
}
