// Walks the ray of a pixel through the glass of one body, up to what the G-buffer shows. Targets: lib/gbuffer.glsl.
#include "lib/frame.glsl"
#include "lib/voxel_walk.glsl"
#include "lib/paint.glsl"
uniform sampler2D uDepth;
flat in int body;
flat in vec3 cameraCells;
layout(location = 0) out vec4 outTint;
layout(location = 1) out vec4 outSurface;

vec3 transmittance(Layout shape, int index, int slot, ivec3 cell) {
    Entry entry = readEntry(shape.palette, index);
    vec3 linear = pow(paintedColor(body, shape, slot, cell, entry.color), vec3(2.2));
    vec3 hue = linear / max(max(linear.r, linear.g), max(linear.b, 0.01));
    return (1.0 - entry.opacity) * mix(vec3(1.0), hue, 0.7);
}

void main() {
    Placement place = readPlacement(body);
    Layout shape = readLayout(body);
    vec3 rayCells = rotateBack(place.rotation, viewRay(gl_FragCoord.xy * frame.targetSize.zw)) / place.voxelSize;
    float tMax = texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r;
    CellWalk w;
    if (!startWalk(w, cameraCells, rayCells, 0.0, tMax, shape.low, shape.high)) discard;

    outTint = vec4(1.0);
    outSurface = vec4(0.0);
    bool inPane = false;  // neighbouring cells of glass are one pane
    for (int i = 0; i < 8192; ++i) {
        int slot;
        int size = emptySizeAt(shape, w.cell, slot);
        bool glass = false;
        if (size == 0) {
            int index = indexAt(slot, w.cell);
            glass = isGlass(shape.palette, index);
            if (!glass) break;
            if (!inPane) outTint.rgb *= transmittance(shape, index, slot, w.cell);
            if (outSurface.w == 0.0) {
                vec3 outward = vec3(w.axis) * vec3(1 - 2 * w.ahead);
                vec3 normal = outward == vec3(0.0) ? -normalize(rayCells) : outward;
                outSurface = vec4(rotate(place.rotation, normal), max(w.t, frame.cameraPosition.w));
            }
            size = 1;
        }
        inPane = glass;
        leaveBlock(w, size);
        if (!(w.t < tMax) || !insideCells(w.cell, shape.low, shape.high)) break;
    }
    if (outSurface.w == 0.0) discard;
}
