// Wet surfaces: changes the G-buffer where rain falls. A film of water darkens and smooths porous materials (Lagarde
// 2012, "Water drop 3b"), and level ground has puddles. A ray up along the rain finds what is under a roof.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"

uniform float uMaxDistance;  // metres: a roof higher up does not count

in vec2 uv;
layout(location = 0) out vec4 outAlbedo;
layout(location = 1) out vec4 outMaterial;

const float kRainAngle = 0.12;    // radians: spread of the rain's direction
const float kPuddleMetres = 2.2;  // size of a puddle

/// How full a hollow of level ground is: above 0 in puddles, below 0 elsewhere; about -1 to 0.5.
float puddleDepth(vec2 place, float wetness) {
    float hollows = 0.8 * fractalNoise(place / kPuddleMetres, 3) + 0.2 * valueNoise(place * 2.7);
    return hollows - mix(0.92, 0.47, wetness);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    float up = s.normal.y;
    if (!s.lit || up < -0.3) discard;
    vec3 world = worldFromDepth(uv, s.depth);
    vec3 rain = coneDirection(vec3(0, 1, 0), kRainAngle, blueNoise(pixel, 33, frame.counters.x));
    // Walls get slanted rain only.
    rain = normalize(rain + s.normal * (1.0 - max(up, 0.0)) * 0.6);
    float t;
    if (shadowTrace(surfaceOrigin(world, s.normal, s.fine), rain, uMaxDistance, t)) discard;

    float wetness = frame.groundColor.w;
    vec2 place = fract(world.xz / 512.0) * 512.0;
    float film = smoothstep(0.0, 0.6, wetness) * mix(0.35, 1.0, max(up, 0.0));
    float puddle = up > 0.9 ? smoothstep(0.0, 0.05, puddleDepth(place, wetness)) : 0.0;
    float porous = smoothstep(0.25, 0.7, s.roughness) * (1.0 - s.metallic);
    // The alphas stay: palette index and motion.
    vec4 albedo = texelFetch(uAlbedo, pixel, 0), material = texelFetch(uMaterial, pixel, 0);
    outAlbedo = vec4(albedo.rgb * (1.0 - porous * (0.28 * film + 0.10 * puddle)), albedo.a);
    float damp = film * smoothstep(0.3, 0.9, up);
    vec3 wet = vec3(mix(0.34, 0.02, puddle), s.metallic, mix(0.035, 0.05, puddle));
    outMaterial = vec4(mix(material.rgb, wet, max(puddle, 0.75 * damp)), material.a);
}
