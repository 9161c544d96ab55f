// Puts what lies before the host's image over it, in its framebuffer. Where nothing does, its pixels stay as they are.
#include "lib/frame.glsl"
#include "lib/color.glsl"
#include "lib/display.glsl"
#include "lib/host_image.glsl"

uniform sampler2D uRadiance;  // the host's image with all layers
uniform sampler2D uDepth;     // 0 where the image is not the host's

out vec4 color;

const float kRounding = 0.002;  // relative, of a half float

void main() {
    ivec2 there = ivec2(gl_FragCoord.xy), pixel = hostPixel(there);
    if (texelFetch(uDepth, pixel, 0).r <= 0.0) discard;
    vec3 before = hostRadiance(pixel), now = texelFetch(uRadiance, pixel, 0).rgb;
    if (all(lessThanEqual(abs(now - before), kRounding * before + 1e-5))) discard;
    now *= exposureNow();
    color = vec4(uLinear ? now : toDisplay(now, (vec2(pixel) + 0.5) * frame.targetSize.zw),
                 texelFetch(uHostColor, there, 0).a);
}
