// A ray through the glass of one body. Needs lib/frame, voxel_walk, paint.

/// The panes that a ray crosses.
struct Panes {
    vec3 tint;  // transmittance of all of them
    float first,
        last;     // t of the nearest and the farthest, in lengths of the direction; kFarthest and 0 if there is none
    vec3 normal;  // of the nearest, in the body's space; 0 if the ray begins in it
};
const Panes kNoPanes = Panes(vec3(1.0), kFarthest, 0.0, vec3(0.0));

/// Transmittance of a voxel of glass. Its hue tints the light; its brightness does not darken it.
vec3 transmittance(int body, Layout shape, int index, int slot, ivec3 cell) {
    Entry entry = readEntry(shape.palette, index);
    vec3 linear = pow(paintedColor(body, shape, slot, cell, entry.color), vec3(2.2));
    vec3 hue = linear / max(max(linear.r, linear.g), max(linear.b, 0.01));
    return (1.0 - entry.opacity) * mix(vec3(1.0), hue, 0.7);
}

/// The panes up to the first opaque voxel, or to tMax.
Panes walkGlass(int body, Layout shape, vec3 originCells, vec3 rayCells, float tMax) {
    Panes panes = kNoPanes;
    CellWalk w;
    if (!startWalk(w, originCells, rayCells, 0.0, tMax, shape.low, shape.high)) return panes;
    for (int i = 0; i < kMaxSteps; ++i) {
        int slot, steps = 0;
        if (!findSolid(w, shape, tMax, slot, steps)) break;
        int index = indexAt(slot, w.cell);
        if (!isGlass(shape.palette, index)) break;
        // Neighbouring cells of glass are one pane.
        if (i == 0 || steps > 1) panes.tint *= transmittance(body, shape, index, slot, w.cell);
        if (i == 0) {
            panes.first = w.t;
            panes.normal = vec3(w.axis * (1 - 2 * w.ahead));
        }
        panes.last = w.t;
        leaveBlock(w, 1);
        if (!(w.t < tMax) || !insideCells(w.cell, shape.low, shape.high)) break;
    }
    return panes;
}
