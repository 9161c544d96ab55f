// An object as Teardown draws it: its oriented box, in a draw call of its own.
#include "lib/frame.glsl"
#include "lib/bodies.glsl"
uniform int uBody;
uniform ivec3 uSize;
flat out vec3 cameraCells;  // the camera in the body's cells

void main() {
    // The 36 corners of a cube's 12 triangles, three bits each.
    const int kCorners[36] = int[36](0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0,
                                     3, 1, 4, 5, 7, 4, 7, 6);
    int corner = kCorners[gl_VertexID];
    Placement place = readTransform(uBody);
    vec3 cell = vec3(ivec3(corner, corner >> 1, corner >> 2) & 1) * vec3(uSize);
    gl_Position = frame.viewProjection * vec4(place.position + rotate(place.rotation, cell * place.voxelSize), 1.0);
    cameraCells = rotateBack(place.rotation, frame.cameraPosition.xyz - place.position) / place.voxelSize;
}
