// Which pixels reflect enough to be worth a mirror ray. Needs lib/gbuffer, frame, brdf.
uniform sampler2D uGlassSurface;
uniform bool uHasGlass;

const float kMinMirrorShare = 0.012;  // share of the light that is reflected

struct Mirror {
    vec3 position, normal, view;
    float roughness;
    bool fine;    // as of a Surface
    float share;  // of the light that it reflects toward the camera; 0 if it is too rough
};

/// The nearest pane of a pixel, else its surface.
Mirror mirrorAt(ivec2 pixel, vec2 uv) {
    Surface s = readSurface(pixel);
    vec3 color = texelFetch(uAlbedo, pixel, 0).rgb;
    float brightest = srgbToLinear(vec3(max(color.r, max(color.g, color.b)))).r;  // one power instead of three
    float f0 = max(s.reflectivity, s.metallic * brightest);
    vec4 pane = uHasGlass ? texelFetch(uGlassSurface, pixel, 0) : vec4(0.0);
    Mirror m;
    bool isPane = pane.w > 0.0, isEntered = pane.xyz != vec3(0.0);
    m.normal = isPane && isEntered ? normalize(pane.xyz) : s.normal;
    m.fine = !isPane && s.fine;
    m.roughness = isPane ? 0.0 : s.roughness;
    f0 = isPane ? (isEntered ? kPaneReflectance : 0.0) : s.lit ? f0 : 0.0;
    m.position = worldFromDepth(uv, isPane ? pane.w : s.depth);
    m.view = toEye(m.position);
    m.share = f0 <= 0.0 ? 0.0 : (1.0 - smoothstep(0.35, 0.6, m.roughness)) * fresnel(vec3(f0), dot(m.normal, m.view)).x;
    return m;
}
