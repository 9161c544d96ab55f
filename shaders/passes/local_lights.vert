// A quad for each tile that a local light may reach, at the far plane as lib/fullscreen_far.vert. Other quads have no
// area.
#include "lib/frame.glsl"
#include "lib/sampling.glsl"
#include "lib/local_lights.glsl"

void main() {
    const vec2 kCorners[6] = vec2[6](vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 0), vec2(1, 1), vec2(0, 1));
    vec2 tile = vec2(gl_InstanceID % uLightGrid.x, gl_InstanceID / uLightGrid.x);
    bool reached = lightsAt(ivec2(tile) * kTilePixels, -1.0).y > 0;
    vec2 corner = (tile + (reached ? kCorners[gl_VertexID] : vec2(0.0))) * float(kTilePixels) * frame.targetSize.zw;
    gl_Position = vec4(corner * 2.0 - 1.0, 1.0, 1.0);
}
