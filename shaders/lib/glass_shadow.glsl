// Transmittance of glass for sunlight, from the map of render/passes/glass_shadow_pass.h. The map is a shadow map with
// colours: a texel holds the product of the tints of all panes on its sun ray and the depth of the last one. As with
// percentage-closer filtering (Reeves et al. 1987) each of four texels is compared first and the results are blended.
uniform bool uGlassShadow;
uniform sampler2D uGlassShadowMap;               // rgb transmittance, a distance of the last pane toward the sun
uniform vec4 uGlassShadowRight, uGlassShadowUp;  // uv in the map = dot(xyz, position) + w
uniform vec4 uGlassShadowSun;                    // distance toward the sun = dot(xyz, position) + w

vec3 sunThroughGlass(vec3 position) {
    if (!uGlassShadow) return vec3(1.0);
    vec2 place = vec2(dot(uGlassShadowRight.xyz, position) + uGlassShadowRight.w,
                      dot(uGlassShadowUp.xyz, position) + uGlassShadowUp.w);
    vec2 edge = min(place, 1.0 - place);
    if (min(edge.x, edge.y) <= 0.0) return vec3(1.0);
    float toward = dot(uGlassShadowSun.xyz, position) + uGlassShadowSun.w;
    // Positions on the sunny side of the last pane are clear. Panes behind opaque things are not in the map.
    vec2 size = vec2(textureSize(uGlassShadowMap, 0));
    vec2 corner = place * size - 0.5;
    vec2 f = fract(corner);
    ivec2 base = ivec2(floor(corner));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        vec4 panes = texelFetch(uGlassShadowMap, clamp(base + offset, ivec2(0), ivec2(size) - 1), 0);
        vec2 w = mix(1.0 - f, f, vec2(offset));
        sum += w.x * w.y * (toward < panes.a - 0.04 ? panes.rgb : vec3(1.0));
    }
    return mix(vec3(1.0), sum, smoothstep(0.0, 0.05, min(edge.x, edge.y)));
}
