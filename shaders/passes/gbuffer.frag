// Primary visibility: walks the ray of a pixel through the bodies of its tile, nearest first, and writes the surface
// that it meets. A surface at the very eye counts as a millimetre away: there is no direction to it. Targets:
// lib/gbuffer.glsl.
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/voxel_walk.glsl"
#include "lib/body_tiles.glsl"
#include "lib/paint.glsl"
#include "lib/detail.glsl"
#include "lib/color.glsl"
layout(location = 0) out vec4 outAlbedo;
layout(location = 1) out vec4 outNormal;
layout(location = 2) out vec4 outMaterial;
layout(location = 3) out vec2 outMotion;
layout(location = 4) out float outDepth;
layout(location = 5) out float outGlass;  // 1 where glass lies before it; only in scenes with glass

/// uv of a world position. Positions at or behind the camera are clamped to what a half float holds.
vec2 screenUv(mat4 viewProjection, vec3 world) {
    vec4 clip = viewProjection * vec4(world, 1.0);
    return clamp(clip.xy / max(clip.w, 1e-4) * 0.5 + 0.5, -8.0, 8.0);
}

void main() {
    ivec2 list = tileList(ivec2(gl_FragCoord.xy));
    VoxelHit best = VoxelHit(false, ivec3(0), 0, 0, kSkyDepth, vec3(0.0), 0, kFarthest);
    float glassT = kFarthest;
    BodyView nearestView;
    int i = list.x;
    do {
        if (i >= list.y) break;
        BodyView view = bodyViewAt(i, gl_FragCoord.xy);
        VoxelHit hit = walkVoxels(view.shape, view.camera, view.ray, 0.0, best.t, kStopAtOpaque);
        glassT = min(glassT, hit.glassT);
        if (hit.hit) {
            best = hit;
            nearestView = view;
        }
    } while (isNearer(++i, list.y, best.t));
    bool behindGlass = glassT < best.t;
    if (!best.hit && !behindGlass) discard;
    outGlass = float(behindGlass);
    if (!best.hit) {
        outAlbedo = outNormal = outMaterial = vec4(0.0);
        outMotion = vec2(0.0);
        outDepth = kSkyDepth;
        gl_FragDepth = 1.0;
        return;
    }

    InstanceTransform place = readTransform(nearestView.instance);
    Entry entry = readEntry(nearestView.shape.palette, best.index);
    float depth = max(best.t, kNearestSurface);
    vec3 pointBody = (nearestView.camera + nearestView.ray * depth) * place.voxelSize;
    vec3 world = worldFromDepth(gl_FragCoord.xy * frame.targetSize.zw, depth);
    vec3 lastWorld = place.moved > 0.0 ? place.lastPosition + rotate(place.lastRotation, pointBody) : world;

    float voxelPixels = place.voxelSize / pixelMetres(depth);
    Detail detail = detailAt(entry.detail, best.cell, best.normal, voxelPixels);
    vec3 color =
        paintedColor(nearestView.instance, nearestView.shape, best.slot, best.cell, entry.color) * detail.color;
    outAlbedo = vec4(color, float(best.index) / 255.0);
    float emission = halfRange(entry.emission);
    bool fine = place.voxelSize < 0.9999 * kShadowCell;
    outNormal = vec4(rotate(place.rotation, best.normal), fine ? -(kFineVoxels + emission) : emission);
    outMaterial = vec4(entry.roughness * detail.roughness, entry.metallic, entry.reflectivity,
                       abs(place.moved - encodeTilt(detail.tilt) / 255.0));
    outMotion =
        gl_FragCoord.xy * frame.targetSize.zw + frame.jitter.xy - screenUv(frame.previousViewProjection, lastWorld);
    outDepth = depth;
    gl_FragDepth = surfaceDepthValue(depth);
}
