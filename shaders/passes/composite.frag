// Shades surfaces with the light that the other passes have found. Linear radiance toward the camera:
//   L = diffuse albedo (light + sun / pi) (1 - F) + sun highlight + F mirrored + lights' highlights + emission
// with F = Fresnel's reflectance for light from all around. `mirrored` is what a mirror ray brought, or on rough
// surfaces the mean radiance around (without the local lights, which have highlights of their own). The haze between
// camera and surface comes last. The inside of a voxel, which no light reaches, is seen in its dim colour, so that a
// camera in a wall shows what it is in, the same in every frame.
#include "lib/constants.glsl"
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/brdf.glsl"
#include "lib/bevel.glsl"
#include "lib/sky.glsl"
#include "lib/color.glsl"
#include "lib/glass_shadow.glsl"
#include "lib/surface_history.glsl"

uniform sampler2D uLight;  // rgb mean radiance from sky and lights, a share of the sun
uniform bool uBevel;
uniform bool uDetail;
uniform bool uHasLocalLights;
uniform sampler2D uSpecular;  // rgb highlights of local lights, a luminance of their part of the light
uniform sampler2D uSurface;   // lib/surface_history.glsl
uniform bool uHasReflections;
uniform sampler2D uReflection;
uniform bool uHasGlass;
uniform sampler2D uGlassSurface;

const float kMaxSunHighlight = 30.0;  // radiance

in vec2 uv;
layout(location = 0) out vec4 radiance;
layout(location = 1) out vec4 diffuseFraction;  // x: the share of it that goes to all sides alike, for lib/bounce.glsl

const float kInsideLight = 0.12;  // inside a voxel: mean radiance at exposure 1

/// The normal of a face with detail: lib/detail.glsl.
vec3 perturbedNormal(vec3 normal, vec2 tilt) {
    vec3 across = normalize(abs(normal.y) > 0.9 ? cross(normal, vec3(0, 0, 1)) : cross(vec3(0, 1, 0), normal));
    return normalize(normal + (across * tilt.x + cross(normal, across) * tilt.y) * kMaxTilt);
}

/// Highlights of lights, blurred over the 3x3 pixels of the same face. These weights remove the highest frequencies,
/// where blue noise has its power.
vec4 filteredHighlights(Surface s, ivec2 pixel) {
    vec2 centre = texelFetch(uSurface, pixel, 0).xy;
    float tolerance = depthTolerance(worldFromDepth(uv, s.depth), s.normal, s.depth);
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int i = 0; i < 9; ++i) {
        ivec2 beside = ivec2(i % 3, i / 3) - 1;
        ivec2 p = clamp(pixel + beside, ivec2(0), ivec2(frame.targetSize.xy) - 1);
        vec2 neighbour = texelFetch(uSurface, p, 0).xy;
        float weight = neighbour.y == centre.y && abs(neighbour.x - centre.x) <= tolerance
                           ? float((2 - abs(beside.x)) * (2 - abs(beside.y)))
                           : 0.0;
        sum += weight * texelFetch(uSpecular, p, 0);
        weights += weight;
    }
    return sum / max(weights, 1.0);
}

/// viewIndependent: the part that goes to all sides alike, with the mean of what is reflected.
vec3 surfaceRadiance(Surface s, vec3 view, ivec2 pixel, out vec3 viewIndependent) {
    vec3 normal = uBevel ? bevelledNormal(s, pixel) : s.normal;
    if (uDetail) normal = perturbedNormal(normal, s.tilt);
    vec4 light = texelFetch(uLight, pixel, 0);
    vec3 sun = frame.sunColor.rgb * light.a * max(dot(normal, frame.sunDirection.xyz), 0.0);
    if (light.a > 0.0) sun *= sunThroughGlass(worldFromDepth(uv, s.depth));
    vec3 f0 = mix(vec3(s.reflectivity), s.albedo, s.metallic);
    vec3 arriving = light.rgb + sun / kPi, diffuse = s.albedo * (1.0 - s.metallic) * arriving,
         glow = s.albedo * s.emission;

    viewIndependent = diffuse * (1.0 - f0) + f0 * arriving + glow;
    vec3 halfVector = normalize(view + frame.sunDirection.xyz);
    vec3 highlight =
        sun * fresnel(f0, dot(view, halfVector)) * specularLobe(normal, view, frame.sunDirection.xyz, s.roughness);

    vec3 share = fresnelRough(f0, dot(normal, view), s.roughness);
    vec3 mirrored = light.rgb;
    vec3 highlights = vec3(0.0);
    float smoothness = 1.0 - smoothstep(0.35, 0.6, s.roughness);
    if (uHasLocalLights) {
        // Local lights are reflected by their highlights: they are taken out of the mean light, which has their hue.
        vec4 specular = filteredHighlights(s, pixel);
        highlights = specular.rgb;
        vec3 tint = specular.rgb / max(f0, vec3(0.01));
        mirrored = max(mirrored - tint * (specular.a / max(luminance(tint), 1e-4)), vec3(0.0));
    }
    // Behind a pane the mirror ray belongs to the pane.
    if (uHasReflections && !(uHasGlass && texelFetch(uGlassSurface, pixel, 0).w > 0.0)) {
        vec4 traced = texelFetch(uReflection, pixel, 0);
        mirrored = mix(mirrored, traced.rgb, traced.a * smoothness);
        // Mirror rays of smooth surfaces have met the lights' emissive voxels themselves.
        highlights *= mix(1.0, analyticHighlightShare(s.roughness), traced.a);
    }
    return diffuse * (1.0 - share) + min(highlight, vec3(kMaxSunHighlight)) + mirrored * share + highlights + glow;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    vec3 ray = viewRay(uv);
    vec3 direction = normalize(ray);
    vec3 viewIndependent = s.albedo * (kInsideLight / max(frame.exposure.x, 1e-3) + s.emission);
    vec3 color = viewIndependent;
    if (s.lit) color = surfaceRadiance(s, -direction, pixel, viewIndependent);
    diffuseFraction = vec4(clamp(luminance(viewIndependent) / max(luminance(color), 1e-4), 0.0, 1.0));
    color = mix(color, hazeRadiance(direction), hazeAmount(length(ray) * s.depth));
    radiance = vec4(halfRange(color), 1.0);
}
