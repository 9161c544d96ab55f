// Walks a ray of the sun through the glass of one body, as far as the sun gets. Blended: colours multiply, of alphas the least stays.
#include "lib/frame.glsl"
#include "lib/voxel_walk.glsl"
#include "lib/paint.glsl"
#include "lib/glass_walk.glsl"
#include "lib/shadow_trace.glsl"

uniform vec3 uMapCorner, uTexelRight, uTexelUp;  // world place of a texel = corner + along x * column + along y * row, high over everything
uniform float uMapHeight;                     // metres from there to where alpha counts from
flat in int body;
out vec4 shadow;

void main() {
    vec3 origin = uMapCorner + uTexelRight * gl_FragCoord.x + uTexelUp * gl_FragCoord.y;
    vec3 ray = -frame.sunDirection.xyz;
    float tMax;
    shadowTrace(origin, ray, 2.0 * uMapHeight, tMax);
    InstanceTransform place = readTransform(body);
    Layout shape = readLayout(body);
    vec3 originCells = rotateBack(place.rotation, origin - place.position) / place.voxelSize;
    Panes panes = walkGlass(body, shape, originCells, rotateBack(place.rotation, ray) / place.voxelSize, tMax);
    if (panes.first == kFarthest) discard;
    shadow = vec4(panes.tint, uMapHeight - panes.last);
}
