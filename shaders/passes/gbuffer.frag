// Walks the ray of a pixel through one body and writes the surface it meets. Targets: lib/gbuffer.glsl.
#include "lib/frame.glsl"
#include "lib/voxel_walk.glsl"
#include "lib/paint.glsl"
uniform sampler2D uDepthSoFar;  // linear depth of the bodies drawn before this batch
flat in int body;
flat in vec3 cameraCells;
layout(location = 0) out vec4 outAlbedo;
layout(location = 1) out vec4 outNormal;
layout(location = 2) out vec4 outMaterial;
layout(location = 3) out vec2 outMotion;
layout(location = 4) out float outDepth;

vec2 screenUv(mat4 viewProjection, vec3 world) {
    vec4 clip = viewProjection * vec4(world, 1.0);
    return clip.xy / clip.w * 0.5 + 0.5;
}

// What the depth buffer holds for a linear depth, as the projection of render/frame_camera.cpp makes it.
float depthBufferValue(float linear) {
    float near = frame.cameraPosition.w, far = frame.cameraForward.w;
    return far * (linear - near) / (linear * (far - near));
}

void main() {
    Placement place = readPlacement(body);
    Layout shape = readLayout(body);
    vec3 rayWorld = viewRay(gl_FragCoord.xy * frame.targetSize.zw);
    vec3 rayCells = rotateBack(place.rotation, rayWorld) / place.voxelSize;
    float tMax = texelFetch(uDepthSoFar, ivec2(gl_FragCoord.xy), 0).r;
    VoxelHit hit = walkVoxels(shape, cameraCells, rayCells, 0.0, tMax, kStopAtOpaque);
    if (!hit.hit) discard;

    Entry entry = readEntry(shape.palette, hit.index);
    vec3 normal = hit.normal == vec3(0.0) ? -normalize(rayCells) : hit.normal;
    vec3 pointBody = (cameraCells + rayCells * hit.t) * place.voxelSize;
    vec3 world = frame.cameraPosition.xyz + rayWorld * hit.t;
    vec3 lastWorld = place.moved > 0.0 ? place.lastPosition + rotate(place.lastRotation, pointBody) : world;

    outAlbedo = vec4(paintedColor(body, shape, hit.slot, hit.cell, entry.color), float(hit.index) / 255.0);
    outNormal = vec4(rotate(place.rotation, normal), entry.emission);
    outMaterial = vec4(entry.roughness, entry.metallic, entry.reflectivity, place.moved);
    outMotion = screenUv(frame.viewProjectionPlain, world) - screenUv(frame.previousViewProjection, lastWorld);
    outDepth = hit.t;
    gl_FragDepth = clamp(depthBufferValue(max(hit.t, frame.cameraPosition.w)), 0.0, 1.0);
}
