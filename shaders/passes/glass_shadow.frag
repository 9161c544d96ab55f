// Walks a sun ray through the glass of one body, up to the first opaque surface. Blending multiplies the colours of all
// bodies and keeps the least alpha.
#include "lib/frame.glsl"
#include "lib/voxel_walk.glsl"
#include "lib/paint.glsl"
#include "lib/glass_walk.glsl"
#include "lib/shadow_trace.glsl"

// World position of a texel, above everything = uMapCorner + uTexelRight * column + uTexelUp * row.
uniform vec3 uMapCorner, uTexelRight, uTexelUp;
uniform float uMapHeight;  // metres from there down to the zero of alpha
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
