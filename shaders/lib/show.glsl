// Shows a target in the host's framebuffer, with the depth of the voxels in the host's convention. For two passes:
// passes/show.frag shows images, passes/show_data.frag whatever else targets hold.
#include "lib/frame.glsl"
#include "lib/constants.glsl"

uniform sampler2D uTarget;
uniform bool uFlipped;       // the first row is the top one
uniform sampler2D uDepth;    // linear; kSkyDepth: sky
uniform vec4 uClipOfDepth;   // in the host's clip space depth d is (x d + y) / (z d + w)
uniform vec2 uWindowOfClip;  // depth in the window: x times that of clip space + y
uniform float uFarthest;     // the same of what is as far as the host can see
uniform vec4 uStatusDot;     // rgb, a 1 if it is drawn: shaders were reloaded, or failed to build
in vec2 uv;
out vec4 color;

/// The place of the target that is shown at this pixel.
vec2 shownPlace() { return uFlipped ? vec2(uv.x, 1.0 - uv.y) : uv; }

float windowDepth(float depth) {
    if (depth >= kSkyDepth) return uFarthest;
    vec2 clip = uClipOfDepth.xz * depth + uClipOfDepth.yw;
    return clamp(clip.x / clip.y * uWindowOfClip.x + uWindowOfClip.y, 0.0, 1.0);
}

/// Writes colour and depth.
void show(vec3 shown) {
    if (uStatusDot.a > 0.0 && distance(gl_FragCoord.xy, vec2(12.0)) < 6.0) shown = uStatusDot.rgb;
    color = vec4(shown, 1.0);
    gl_FragDepth = windowDepth(texelFetch(uDepth, ivec2(shownPlace() * vec2(textureSize(uDepth, 0))), 0).r);
}
