// Albedo by the angle to the sun: a picture without rays.
#include "lib/frame.glsl"
#include "lib/gbuffer.glsl"
in vec2 uv;
out vec4 color;

void main() {
    Surface s = readSurface(ivec2(gl_FragCoord.xy));
    float light = 0.35 + 0.65 * max(dot(s.normal, frame.sunDirection.xyz), 0.0) + 0.1 * s.normal.y;
    vec3 c = s.sky ? frame.skyColor.rgb : s.albedo * (light + s.emission);
    color = vec4(pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0);
}
