// Composites glass over a copy of the image: what is behind, tinted and refracted, and what the nearest pane reflects.
//
// A pane is a plane-parallel plate of thickness d and index n. A ray that meets it at the angle a runs inside at b with
// sin a = n sin b (Snell) and leaves parallel to itself, displaced along the plate by d (tan b - tan a). With the
// tangential part of the direction (length sin a) that is
//   offset = tangential * d (1 / sqrt(n^2 - 1 + cos^2 a) - 1 / cos a)
// The background is read where the displaced point lies on the screen. lib/pane_light.glsl adds the rest.
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"
#include "lib/color.glsl"
#include "lib/pane_light.glsl"

uniform sampler2D uBackground;
uniform bool uHasPaneLight;  // else it is computed here
uniform sampler2D uPaneLight;
uniform bool uRefraction;

const float kThickness = 0.06;               // metres: thinner than a voxel, or windows would look like blocks
const float kRefractiveIndexSquared = 2.25;  // 1.5 squared
const float kMinCosine = 0.2;                // limits the offset at grazing angles

in vec2 uv;
out vec4 radiance;

/// World offset of what lies behind a pane.
vec3 refractionOffset(vec3 direction, vec3 normal) {
    float cosine = max(abs(dot(direction, normal)), kMinCosine);
    vec3 along = direction - normal * dot(direction, normal);
    return along * (kThickness * (inversesqrt(kRefractiveIndexSquared - 1.0 + cosine * cosine) - 1.0 / cosine));
}

/// The pixel that shows what the refracted ray meets.
ivec2 refractedPixel(ivec2 pixel, vec3 ray, vec4 pane, vec3 normal) {
    float depth = texelFetch(uDepth, pixel, 0).r;
    vec3 place = worldFromDepth(gl_FragCoord.xy * frame.targetSize.zw, depth);
    vec4 straight = frame.viewProjection * vec4(place, 1.0);
    vec4 bent = frame.viewProjection * vec4(place + refractionOffset(normalize(ray), normal), 1.0);
    vec2 moved = (bent.xy / max(bent.w, 1e-3) - straight.xy / max(straight.w, 1e-3)) * 0.5 * frame.targetSize.xy;
    ivec2 there = clamp(pixel + ivec2(floor(moved + 0.5)), ivec2(0), ivec2(frame.targetSize.xy) - 1);
    // Not a pixel that shows something in front of the pane.
    return texelFetch(uDepth, there, 0).r > pane.w ? there : pixel;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 pane = texelFetch(uGlassSurface, pixel, 0);
    if (pane.w <= 0.0) discard;
    vec3 ray = viewRay(gl_FragCoord.xy * frame.targetSize.zw);
    bool isRefracted = uRefraction && pane.xyz != vec3(0.0);
    vec4 seen = texelFetch(
        uBackground, isRefracted ? refractedPixel(pixel, ray, pane, normalize(pane.xyz)) : pixel, 0);
    vec4 light = uHasPaneLight ? texelFetch(uPaneLight, pixel, 0) : paneLightAt(pixel, ray);
    vec3 passing = texelFetch(uGlassTint, pixel, 0).rgb * light.a;
    // The reflection does not move with what is behind: the larger its share, the less TAA relies on history.
    radiance = vec4(halfRange(seen.rgb * passing + light.rgb), seen.a * light.a);
}
