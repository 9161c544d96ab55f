// A quad of two triangles for each tile that has something to draw, at the far plane.
#include "lib/frame.glsl"
#include "lib/texels.glsl"
uniform texels1 uTileIds;
uniform ivec2 uTileGrid;  // as in lib/body_tiles.glsl
out vec2 uv;

void main() {
    int tile = int(fetch1(uTileIds, gl_InstanceID));
    ivec2 corner = ivec2(gl_VertexID == 1 || gl_VertexID >= 4 ? 1 : 0,
                         gl_VertexID == 2 || gl_VertexID == 3 || gl_VertexID == 5 ? 1 : 0);
    vec2 pixel = vec2((ivec2(tile % uTileGrid.x, tile / uTileGrid.x) + corner) << uTileGrid.y);
    uv = pixel * frame.targetSize.zw;
    gl_Position = vec4(uv * 2.0 - 1.0, 1.0, 1.0);
}
