// Panes in front of what a pixel shows. Needs lib/frame, brdf, sky.
uniform sampler2D uReflection;
uniform bool uReflections;
uniform sampler2D uGlassTint;
uniform sampler2D uGlassSurface;
uniform bool uGlass;

/// The radiance behind, seen through the panes, and what the nearest one mirrors.
vec3 throughGlass(vec3 behind, vec3 direction, ivec2 pixel) {
    if (!uGlass) return behind;
    vec4 pane = texelFetch(uGlassSurface, pixel, 0);
    if (pane.w <= 0.0) return behind;
    vec3 normal = normalize(pane.xyz);
    float share = fresnel(vec3(0.05), abs(dot(normal, direction))).x;
    vec3 mirrored = uReflections ? texelFetch(uReflection, pixel, 0).rgb : skyRadiance(reflect(direction, normal));
    return mix(behind * texelFetch(uGlassTint, pixel, 0).rgb, mirrored, min(1.6 * share, 1.0));
}

/// Nothing downstream survives a NaN: history would keep it for ever.
vec3 onlyFinite(vec3 c) { return all(lessThan(abs(c), vec3(60000.0))) ? max(c, vec3(0.0)) : vec3(0.0); }
