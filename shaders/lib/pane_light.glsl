// How the panes of a pixel, and what lies before the nearest one, change the light B of what is behind them. With the
// reflected share F, the tint T of all panes and the mirrored light M, panes alone show  P = T (1 - F) B' + F M  of the
// light B' that reaches them. A layer before them, such as haze, leaves the share t of that and adds a. The image B has
// that layer already, B = t B' + a, so that what is seen is
//   t P + a = T (1 - F) B + E    with    E = t F M + a (1 - T (1 - F))
// E is the pane light: rgb E, alpha 1 - F. A further layer in front, such as water (passes/water.frag), makes it
// t E + a (1 - T (1 - F)). The sky is seen without haze, B = B', so that before it E = t F M + a, and t is a part of
// the alpha. Needs lib/frame, brdf, sky, color.
uniform sampler2D uDepth;
uniform sampler2D uGlassTint;
uniform sampler2D uGlassSurface;
uniform bool uHasReflections;
uniform sampler2D uReflection;

/// The pane light behind the haze. ray: viewRay() of the pixel, which must have a pane.
vec4 paneLightAt(ivec2 pixel, vec3 ray) {
    vec4 pane = texelFetch(uGlassSurface, pixel, 0);
    bool isEntered = pane.xyz != vec3(0.0);
    vec3 direction = normalize(ray), normal = isEntered ? normalize(pane.xyz) : -direction;
    float share = min(kPaneScale * fresnel(vec3(kPaneReflectance), abs(dot(normal, direction))).x, 1.0);
    if (!isEntered) share = 0.0;
    vec3 mirrored = uHasReflections ? texelFetch(uReflection, pixel, 0).rgb : skyRadiance(reflect(direction, normal));
    float haze = hazeAmount(length(ray) * pane.w);
    bool isBeforeSky = texelFetch(uDepth, pixel, 0).r >= kSkyDepth;
    float left = (1.0 - share) * (isBeforeSky ? 1.0 - haze : 1.0);
    vec3 covered = isBeforeSky ? vec3(1.0) : 1.0 - texelFetch(uGlassTint, pixel, 0).rgb * left;
    return vec4(halfRange(mirrored * (share * (1.0 - haze)) + hazeRadiance(direction) * haze * covered), left);
}
