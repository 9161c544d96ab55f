// The pixels that a water may cover, as a fan of triangles at the far plane.
#include "lib/texels.glsl"
uniform texels4f uAreaCorners;  // xy uv
uniform int uAreaFirst;         // of this water

void main() {
    int step = gl_VertexID % 3, corner = step == 0 ? 0 : gl_VertexID / 3 + step;
    gl_Position = vec4(fetch4f(uAreaCorners, uAreaFirst + corner).xy * 2.0 - 1.0, 1.0, 1.0);
}
