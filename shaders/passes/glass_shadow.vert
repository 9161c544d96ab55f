// The box of a body with glass, seen from the sun.
#include "lib/frame.glsl"
#include "lib/bodies.glsl"
layout(location = 0) in int instance;
uniform vec4 uRight, uUp;  // uv in the map = dot(xyz, position) + w
flat out int body;

void main() {
    // The 36 corners of a cube's 12 triangles, three bits each.
    const int kCorners[36] = int[36](0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0,
                                     3, 1, 4, 5, 7, 4, 7, 6);
    int corner = kCorners[gl_VertexID];
    InstanceTransform place = readTransform(instance);
    Layout shape = readLayout(instance);
    vec3 cell = vec3((corner & 1) != 0 ? shape.high.x : shape.low.x, (corner & 2) != 0 ? shape.high.y : shape.low.y,
                     (corner & 4) != 0 ? shape.high.z : shape.low.z);
    vec3 position = place.position + rotate(place.rotation, cell * place.voxelSize);
    gl_Position =
        vec4(vec2(dot(uRight.xyz, position) + uRight.w, dot(uUp.xyz, position) + uUp.w) * 2.0 - 1.0, 0.0, 1.0);
    body = instance;
}
