// Writes depth where a mirror ray is worth its cost: the pass "reflections" then draws only there.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/brdf.glsl"
#include "lib/mirror.glsl"

in vec2 uv;

void main() {
    if (mirrorAt(ivec2(gl_FragCoord.xy), uv).share < kMinMirrorShare) discard;
}
