// Walks the ray of a pixel through the glass of its tile's bodies, up to the G-buffer's surface. Targets:
// lib/gbuffer.glsl.
#include "lib/frame.glsl"
#include "lib/voxel_walk.glsl"
#include "lib/body_tiles.glsl"
#include "lib/paint.glsl"
#include "lib/glass_walk.glsl"
uniform sampler2D uDepth;
layout(location = 0) out vec4 outTint;
layout(location = 1) out vec4 outSurface;

void main() {
    float tMax = texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r;
    Panes all = kNoPanes;
    int nearestBody = -1;
    ivec2 list = tileList(ivec2(gl_FragCoord.xy));
    int e = list.x;
    do {
        if (!isNearer(e, list.y, tMax)) break;
        BodyView view = bodyViewAt(e, gl_FragCoord.xy);
        Panes panes = walkGlass(view.instance, view.shape, view.camera, view.ray, tMax);
        all.tint *= panes.tint;
        if (panes.first < all.first) {
            all.first = panes.first;
            all.normal = panes.normal;
            nearestBody = view.instance;
        }
    } while (isNearer(++e, list.y, tMax));
    if (nearestBody < 0) discard;
    outTint = vec4(all.tint, 1.0);
    outSurface = vec4(rotate(readTransform(nearestBody).rotation, all.normal), max(all.first, frame.cameraPosition.w));
}
