// The background below the horizon: see background.frag.
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sky.glsl"
#include "lib/color.glsl"

in vec2 uv;
out vec4 radiance;

void main() {
    vec3 direction = normalize(viewRay(uv));
    vec3 color = fieldsBelow(viewOrigin(uv), direction);
    radiance = vec4(halfRange(color), 1.0);
}
