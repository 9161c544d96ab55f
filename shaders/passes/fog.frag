// Applies fog: in-scattered light x (1 - transmittance), and the transmittance as alpha. Blended as colour + alpha x
// image.
#include "lib/frame.glsl"
#include "lib/fog.glsl"

uniform sampler2D uLight;  // at half the size: mean light that the fog scatters (passes/fog_light.frag)
uniform sampler2D uDepth;
uniform float uWaterSurface;  // height of the water that the camera is in; far below it if it is in none

in vec2 uv;
out vec4 color;

void main() {
    vec3 toPixel = viewRay(uv);
    float stretch = length(toPixel);
    float depth = min(texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r * stretch, kMaxFogDistance);
    // A ray that begins in water is bent or mirrored at the surface: passes/water.frag follows it, through the fog too.
    float start = viewOrigin(uv).y, upward = toPixel.y / stretch;
    bool isInWater = start + toPixel.y * kWaterPort < uWaterSurface;
    float left = isInWater ? 1.0 : exp(-fogOpticalDepth(start, upward, depth));
    color = vec4(texture(uLight, uv).rgb * frame.fogTint.rgb * (1.0 - left), left);
}
