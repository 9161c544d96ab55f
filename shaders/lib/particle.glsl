// What passes/particles.vert passes on to the fragment shaders of particles. Their colour is premultiplied by alpha.
#include "lib/constants.glsl"
#include "lib/particle_kinds.glsl"
#include "lib/frame.glsl"

uniform sampler2D uDepth;
uniform sampler2D uPuffNoise;  // tiles: r noise, gb its gradient around one half

in vec2 corner;
in vec4 noiseUv;
in vec3 sunLight;
in vec3 airLight;
flat in vec4 particle;
flat in vec4 tintOut;
flat in vec4 stateOut;
flat in vec4 haze;
flat in vec4 depths;
flat in int kind;
out vec4 color;

float surfaceDepth() { return texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r; }

/// The fade of "soft particles": the share of a sphere's chord through this pixel that lies before the surface and in
/// front of the camera, so that gas has no hard edge at a wall.
float softFade(float halfChord) {
    float front = max(depths.x - halfChord, 0.15), back = min(depths.x + halfChord, surfaceDepth());
    return clamp((back - front) / max(2.0 * particle.w, 1e-3), 0.0, 1.0) * depths.y;
}

vec4 applyHaze(vec4 c) { return vec4(mix(c.rgb, haze.rgb * c.a, haze.a), c.a); }
