// Lets depth be written where a reflection ray is worth its price: the pass "reflections" then draws only there.
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "lib/brdf.glsl"
#include "lib/mirror.glsl"

in vec2 uv;

void main() {
    if (mirrorAt(ivec2(gl_FragCoord.xy), uv).share < kMinMirrorShare) discard;
}
