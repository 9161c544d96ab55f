// A camera ray for each pixel; the body lies unrotated at the origin. Writes cell and t of the first voxel, -1 for a
// miss.
#include "lib/frame.glsl"
uniform float uVoxelSize;
in vec2 uv;
out vec4 result;

vec4 firstVoxel(vec3 originCells, vec3 direction);

void main() { result = firstVoxel(frame.cameraPosition.xyz / uVoxelSize, viewRay(uv) / uVoxelSize); }
