// Walks the ray of a pixel through one object's 3D texture and writes the same targets as passes/gbuffer.frag.
#include "lib/frame.glsl"
#include "lib/bodies.glsl"
#include "../tests/benchmark/render/shaders/dense_grid.glsl"
#include "../tests/benchmark/render/shaders/teardown_walk.glsl"
uniform int uBody;
uniform sampler2D uDepthSoFar;  // linear depth as of the last copy
flat in vec3 cameraCells;
layout(location = 0) out vec4 outAlbedo;
layout(location = 1) out vec4 outNormal;
layout(location = 2) out vec4 outMaterial;
layout(location = 3) out vec2 outMotion;
layout(location = 4) out float outDepth;

void main() {
    Placement place = readTransform(uBody);
    vec2 uv = gl_FragCoord.xy * frame.targetSize.zw;
    vec3 rayWorld = viewRay(uv);
    vec3 rayCells = rotateBack(place.rotation, rayWorld) / place.voxelSize;
    vec3 normal;
    vec4 hit = firstVoxel(cameraCells, rayCells, texelFetch(uDepthSoFar, ivec2(gl_FragCoord.xy), 0).r, normal);
    if (hit.w < 0.0) discard;
    int index = int(texelFetch(uVoxels, ivec3(hit.xyz), 0).r * 255.0 + 0.5);
    Entry entry = readEntry(int(texelFetch(uLayouts, uBody * 4).y), index);
    vec3 pointBody = (cameraCells + rayCells * hit.w) * place.voxelSize;
    vec3 world = frame.cameraPosition.xyz + rayWorld * hit.w;
    vec3 lastWorld = place.moved > 0.0 ? place.lastPosition + rotate(place.lastRotation, pointBody) : world;
    vec4 before = frame.previousViewProjection * vec4(lastWorld, 1.0);
    outAlbedo = vec4(entry.color, float(index) / 255.0);
    outNormal = vec4(rotate(place.rotation, normal), entry.emission);
    outMaterial = vec4(entry.roughness, entry.metallic, entry.reflectivity, place.moved);
    outMotion = uv + frame.jitter.xy - (before.xy / before.w * 0.5 + 0.5);
    outDepth = hit.w;
    float near = frame.cameraPosition.w, far = frame.cameraForward.w, depth = max(hit.w, near);
    gl_FragDepth = clamp(far * (depth - near) / (depth * (far - near)), 0.0, 1.0);
}
