// The background where there is no surface: sky, clouds, hills, fields.
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/sky.glsl"
#include "lib/color.glsl"

uniform float uPlaneHeight;  // of the fields around the level, metres

in vec2 uv;
out vec4 radiance;

void main() {
    vec3 direction = normalize(viewRay(uv));
    vec3 color = backgroundRadiance(direction, frame.cameraPosition.y - uPlaneHeight);
    radiance = vec4(halfRange(color), 1.0);
}
