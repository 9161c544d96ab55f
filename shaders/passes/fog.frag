// Applies fog: in-scattered light x (1 - transmittance), and the transmittance as alpha. Blended as colour + alpha x
// image.
#include "lib/frame.glsl"
#include "lib/fog.glsl"

uniform sampler2D uLight;  // at half the size: mean light that the fog scatters (passes/fog_light.frag)
uniform sampler2D uDepth;

in vec2 uv;
out vec4 color;

void main() {
    vec3 toPixel = viewRay(uv);
    float stretch = length(toPixel);
    float depth = min(texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r * stretch, kMaxFogDistance);
    float left = exp(-fogOpticalDepth(toPixel.y / stretch, depth));
    color = vec4(texture(uLight, uv).rgb * frame.fogTint.rgb * (1.0 - left), left);
}
