// A small bright centre with a halo and a few faint rays.
#include "lib/color.glsl"
in vec2 corner;
flat in vec3 glare;
out vec4 color;

void main() {
    float r2 = dot(corner, corner), edge = max(1.0 - r2, 0.0);
    float rays = 0.75 + 0.25 * cos(6.0 * atan(corner.y, corner.x + 1e-6));
    float middle = 1.0 / (1.0 + 120.0 * r2), halo = 0.06 * rays;
    color = vec4(halfRange(glare * ((3.0 * middle + halo) * edge * edge)), 0.0);
}
