// Takes over what the host has drawn nearer than the voxels: its radiance and depth, over which layers are then drawn.
// Other pixels have a depth of 0, so that nothing lies before them.
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "lib/display.glsl"
#include "lib/host_image.glsl"

uniform sampler2D uHostDepth;  // depth in the window
uniform sampler2D uDepth;      // linear, of the voxels
uniform vec4 uClipOfDepth;     // passes/show.frag
uniform vec2 uWindowOfClip;
uniform float uFarthest;

layout(location = 0) out vec4 radiance;
layout(location = 1) out float depth;
layout(location = 2) out float glassMask;

/// Linear depth of a depth in the window.
float linearDepth(float window) {
    float clip = (window - uWindowOfClip.y) / uWindowOfClip.x;
    return (clip * uClipOfDepth.w - uClipOfDepth.y) / (uClipOfDepth.x - clip * uClipOfDepth.z);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float window = texelFetch(uHostDepth, hostPixel(pixel), 0).r;
    float metres = clamp(linearDepth(window), 0.0, 0.99 * kSkyDepth);
    bool isHost = window != uFarthest && metres < texelFetch(uDepth, pixel, 0).r;
    radiance = vec4(isHost ? hostRadiance(pixel) : vec3(0.0), 1.0);
    depth = isHost ? metres : 0.0;
    glassMask = float(isHost);
    gl_FragDepth = isHost ? surfaceDepthValue(metres) : 0.0;
}
