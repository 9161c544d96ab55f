// x 1 where a surface faces the sun, y 1 where the sun's centre is seen from there too.
#include "lib/frame.glsl"
#include "lib/gbuffer.glsl"
#include "lib/shadow_trace.glsl"
layout(location = 0) out vec4 outSunlit;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = readSurface(pixel);
    bool facing = !s.sky && dot(s.normal, frame.sunDirection.xyz) > 0.0;
    vec3 world = worldFromDepth(gl_FragCoord.xy * frame.targetSize.zw, s.depth);
    float t;
    bool lit = facing && !shadowTrace(surfaceOrigin(world, s.normal, s.fine), frame.sunDirection.xyz, 100.0, t);
    outSunlit = vec4(facing, lit, 0.0, 0.0);
}
