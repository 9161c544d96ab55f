// The background where no hill reaches: see background.frag.
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"
#include "lib/glass.glsl"

in vec2 uv;
out vec4 radiance;

void main() {
    vec3 direction = normalize(viewRay(uv));
    vec3 color = skyBehind(direction);
    radiance = vec4(onlyFinite(throughGlass(color, direction, ivec2(gl_FragCoord.xy))), 1.0);
}
