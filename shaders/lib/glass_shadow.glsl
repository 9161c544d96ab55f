// What the sun's light has become on its way through glass: see render/passes/glass_shadow_pass.h.
uniform bool uGlassShadow;
uniform sampler2D uGlassShadowMap;               // rgb share that comes through, a how far toward the sun the last pane is
uniform vec4 uGlassShadowRight, uGlassShadowUp;  // place in the map = dot(xyz, position) + w
uniform vec4 uGlassShadowSun;                    // distance toward the sun, as in the map

vec3 sunThroughGlass(vec3 position) {
    if (!uGlassShadow) return vec3(1.0);
    vec2 place = vec2(dot(uGlassShadowRight.xyz, position) + uGlassShadowRight.w, dot(uGlassShadowUp.xyz, position) + uGlassShadowUp.w);
    vec2 edge = min(place, 1.0 - place);
    if (min(edge.x, edge.y) <= 0.0) return vec3(1.0);
    float toward = dot(uGlassShadowSun.xyz, position) + uGlassShadowSun.w;
    // Not what lies before the last pane: what opaque things hide from the sun is not in the map, so there is none behind.
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
