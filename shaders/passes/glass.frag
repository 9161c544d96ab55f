// Walks the ray of a pixel through the glass of its tile's bodies, up to what the G-buffer shows. Targets: lib/gbuffer.glsl.
#include "lib/frame.glsl"
#include "lib/voxel_walk.glsl"
#include "lib/body_tiles.glsl"
#include "lib/paint.glsl"
uniform sampler2D uDepth;
layout(location = 0) out vec4 outTint;
layout(location = 1) out vec4 outSurface;

vec3 transmittance(BodyView view, int index, int slot, ivec3 cell) {
    Entry entry = readEntry(view.shape.palette, index);
    vec3 linear = pow(paintedColor(view.instance, view.shape, slot, cell, entry.color), vec3(2.2));
    vec3 hue = linear / max(max(linear.r, linear.g), max(linear.b, 0.01));
    return (1.0 - entry.opacity) * mix(vec3(1.0), hue, 0.7);
}

void main() {
    float tMax = texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r;
    vec3 tint = vec3(1.0), nearestNormal = vec3(0.0);
    float nearest = tMax;
    int nearestBody = -1;
    ivec2 list = tileList(ivec2(gl_FragCoord.xy));
    for (int e = list.x; e < list.y; ++e) {
        BodyView view = bodyViewAt(e, gl_FragCoord.xy);
        if (view.nearest >= tMax) break;
        CellWalk w;
        if (!startWalk(w, view.camera, view.ray, 0.0, tMax, view.shape.low, view.shape.high)) continue;
        bool first = true;
        for (int i = 0; i < kMostSteps; ++i) {
            int slot, steps = 0;
            if (!findSolid(w, view.shape, tMax, slot, steps)) break;
            int index = indexAt(slot, w.cell);
            if (!isGlass(view.shape.palette, index)) break;
            // Neighbouring cells of glass are one pane.
            if (first || steps > 1) tint *= transmittance(view, index, slot, w.cell);
            first = false;
            if (w.t < nearest) {
                nearest = w.t;
                nearestBody = view.instance;
                nearestNormal = w.axis == ivec3(0) ? -normalize(view.ray) : vec3(w.axis * (1 - 2 * w.ahead));
            }
            leaveBlock(w, 1);
            if (!(w.t < tMax) || !insideCells(w.cell, view.shape.low, view.shape.high)) break;
        }
    }
    if (nearestBody < 0) discard;
    outTint = vec4(tint, 1.0);
    outSurface = vec4(rotate(readPlacement(nearestBody).rotation, nearestNormal), max(nearest, frame.cameraPosition.w));
}
