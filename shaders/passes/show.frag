// Shows any target in the host's framebuffer, with the depth of the voxels in the host's convention. The modes are
// those of ShowPass::Mode in render/passes/show_pass.h; 0 shows colours as they are.
#include "lib/frame.glsl"
#include "lib/constants.glsl"

uniform sampler2D uTarget;
uniform int uMode;
uniform bool uFlipped;        // the first row is the top one
uniform sampler2D uExposure;  // of mode 7
uniform sampler2D uDepth;     // linear; kSkyDepth: sky
uniform vec4 uClipOfDepth;    // in the host's clip space depth d is (x d + y) / (z d + w)
uniform vec2 uWindowOfClip;   // depth in the window: x times that of clip space + y
uniform float uFarthest;      // the same of what is as far as the host can see
uniform vec4 uStatusDot;      // rgb, a 1 if it is drawn: shaders were reloaded, or failed to build
in vec2 uv;
out vec4 color;

float windowDepth(float depth) {
    if (depth >= kSkyDepth) return uFarthest;
    vec2 clip = uClipOfDepth.xz * depth + uClipOfDepth.yw;
    return clamp(clip.x / clip.y * uWindowOfClip.x + uWindowOfClip.y, 0.0, 1.0);
}

void main() {
    vec2 place = uFlipped ? vec2(uv.x, 1.0 - uv.y) : uv;
    vec4 v = texture(uTarget, place);
    vec3 c = v.rgb;
    if (uMode == 1) c = pow(c / (1.0 + c), vec3(1.0 / 2.2));  // radiance
    if (uMode == 2) c = v.rgb * 0.5 + 0.5;                    // directions
    if (uMode == 3) c = vec3(1.0 - exp(-v.r / 20.0));         // metres
    if (uMode == 4) c = vec3(v.rg * 10.0 + 0.5, 0.5);         // motion, uv per frame
    if (uMode == 5) c = vec3(v.a);
    if (uMode == 6) c = vec3(v.b / 32.0);  // frames accumulated
    if (uMode == 7) c *= frame.exposure.x * texelFetch(uExposure, ivec2(0), 0).r;
    if (uStatusDot.a > 0.0 && distance(gl_FragCoord.xy, vec2(12.0)) < 6.0) c = uStatusDot.rgb;
    color = vec4(c, 1.0);
    gl_FragDepth = windowDepth(texelFetch(uDepth, ivec2(place * vec2(textureSize(uDepth, 0))), 0).r);
}
