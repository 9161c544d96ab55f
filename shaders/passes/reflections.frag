// What smooth surfaces and glass mirror: one ray a pixel, spread by roughness. rgb radiance, a 1 where a ray was sent.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"
#include "lib/bounce.glsl"

uniform sampler2D uGlassSurface;
uniform bool uGlass;
uniform sampler2D uLight;

in vec2 uv;
out vec4 reflection;

const float kReach = 40.0;
const float kWeakest = 0.012;  // share of light below which no ray is worth its price

/// Radiance of a mirror ray. The sun's disc is left to the specular lobe, which has no noise.
vec3 mirrored(vec3 origin, vec3 direction, vec3 lightHere) {
    float t;
    if (shadowTrace(origin, direction, kReach, t)) return bounceRadiance(origin + direction * t, direction, lightHere);
    vec3 sky = direction.y > 0.0 ? withHills(withClouds(skyRadiance(direction), direction), direction) : skyRadiance(direction);
    return sky;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    float roughness = s.roughness;
    float f0 = max(s.reflectivity, s.metallic * max(s.albedo.r, max(s.albedo.g, s.albedo.b)));
    vec4 pane = uGlass ? texelFetch(uGlassSurface, pixel, 0) : vec4(0.0);
    bool isPane = pane.w > 0.0;
    reflection = vec4(0.0);
    if (isPane) {
        s.normal = normalize(pane.xyz);
        s.depth = pane.w;
        roughness = 0.0;
        f0 = 0.05;
    } else if (s.sky) {
        return;
    }
    vec3 position = worldFromDepth(uv, s.depth);
    vec3 view = normalize(frame.cameraPosition.xyz - position);
    float share = (1.0 - smoothstep(0.35, 0.6, roughness)) * fresnel(vec3(f0), dot(s.normal, view)).x;
    if (share < kWeakest) return;
    vec3 halfVector = s.normal;
    if (roughness > 0.03) {
        mat3 basis = basisAround(s.normal);
        vec3 h = visibleHalfVector(view * basis, roughness * roughness, blueNoise(pixel, 20, frame.counters.x) * vec2(1.0, 0.85));
        halfVector = basis * h;
    }
    vec3 direction = reflect(-view, halfVector);
    direction += s.normal * max(0.0, 0.02 - dot(direction, s.normal));
    reflection = vec4(mirrored(shadowOrigin(position, s.normal), normalize(direction), texelFetch(uLight, pixel, 0).rgb), 1.0);
}
