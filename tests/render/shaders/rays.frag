// One ray a pixel through body 0.
#include "lib/voxel_walk.glsl"
uniform sampler2D uOrigins;     // w tMax
uniform sampler2D uDirections;
layout(location = 0) out ivec4 outCell;    // w 0 for a miss, else steps
layout(location = 1) out vec4 outNormalT;  // xyz normal, w t

void main() {
    vec4 origin = texelFetch(uOrigins, ivec2(gl_FragCoord.xy), 0);
    vec3 direction = texelFetch(uDirections, ivec2(gl_FragCoord.xy), 0).xyz;
    VoxelHit hit = walkVoxels(readLayout(0), origin.xyz, direction, 0.0, origin.w, kStopAtSolid);
    outCell = ivec4(hit.cell, hit.hit ? hit.steps : 0);
    outNormalT = vec4(hit.normal, hit.t);
}
