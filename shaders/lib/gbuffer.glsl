// What the G-buffer holds and how to read it. Targets (made by render/passes/gbuffer_pass.h):
//   albedo        RGBA8    rgb sRGB colour; a palette index / 255 (0 = sky)
//   normal        RGBA16F  xyz world normal, unit length, or 0 where the pixel's ray begins inside the voxel; w
//                          emission, a multiple of the linear colour, or if its voxels are finer than shadow cells
//                          -(kFineVoxels + emission)
//   material      RGBA8    r roughness, g metallic, b reflectivity: reflectance at normal incidence; a tilt of the face
//                          as decodeTilt() reads it, or 1 less that value if the body moves
//   motion        RG16F    uv of the point now minus its uv in the previous frame, both without jitter
//   depth         R32F     linear: metres along the view axis; kSkyDepth where there is no surface
// Glass (opacity below 255) is not in these. Scenes with glass have three more:
//   glassMask     R8       1 where glass lies before the surface or the sky
//   glassTint     RGBA8    rgb transmittance of all panes before it (1 = no glass)
//   glassSurface  RGBA16F  xyz normal of the nearest pane, or 0 where the ray begins in it: it then reflects nothing;
//                          w its linear depth (0 = no glass)
#include "lib/color.glsl"
#include "lib/constants.glsl"

uniform sampler2D uAlbedo;
uniform sampler2D uNormal;
uniform sampler2D uMaterial;
uniform sampler2D uMotion;
uniform sampler2D uDepth;

struct Surface {
    bool sky;
    bool lit;        // false: the sky, or the inside of a voxel, which no light reaches
    float depth;     // metres along the view axis
    vec3 albedo;     // linear
    vec3 normal;     // world
    float emission;  // radiance = albedo * emission
    bool fine;       // its voxels are smaller than the cells of the shadow volume
    float roughness, metallic, reflectivity;
    float moving;  // 1 if its body moved since the previous frame
    vec2 tilt;     // of a face with detail, along two axes of its own: -1 to 1
};

/// The inverse of encodeTilt() in lib/detail.glsl.
vec2 decodeTilt(float code) {
    return code < 0.5 ? vec2(0.0) : vec2(mod(code - 1.0, 11.0), floor((code - 0.5) / 11.0)) / 5.0 - 1.0;
}

Surface readSurface(ivec2 pixel) {
    Surface s;
    s.depth = texelFetch(uDepth, pixel, 0).r;
    s.sky = s.depth >= kSkyDepth;
    s.albedo = srgbToLinear(texelFetch(uAlbedo, pixel, 0).rgb);
    vec4 normal = texelFetch(uNormal, pixel, 0);
    s.normal = normal.xyz;
    s.lit = !s.sky && s.normal != vec3(0.0);
    s.fine = normal.w < 0.0;
    s.emission = s.fine ? -normal.w - kFineVoxels : normal.w;
    vec4 material = texelFetch(uMaterial, pixel, 0);
    s.roughness = material.r;
    s.metallic = material.g;
    s.reflectivity = material.b;
    s.moving = step(0.5, material.a);
    s.tilt = decodeTilt(floor(abs(s.moving - material.a) * 255.0 + 0.5));
    return s;
}
