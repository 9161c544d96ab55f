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
    // The part of the ray that lies in water has no fog.
    float upward = toPixel.y / stretch, start = viewOrigin(uv).y,
          under = uWaterSurface - start;
    float inWater = under <= 0.0 ? 0.0 : upward > 0.0 ? min(under / upward, depth) : depth;
    float left = exp(fogOpticalDepth(start, upward, inWater) - fogOpticalDepth(start, upward, depth));
    color = vec4(texture(uLight, uv).rgb * frame.fogTint.rgb * (1.0 - left), left);
}
