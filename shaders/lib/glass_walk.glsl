// A ray through the glass of one body. Needs lib/frame, voxel_walk, paint.
struct Panes {
    vec3 tint;          // share of the light that comes through all of them
    float first, last;  // where the ray meets the nearest and the farthest, in lengths of its direction; kFarthest, 0 without any
    vec3 normal;        // of the nearest, in the body
};
const Panes kNoPanes = Panes(vec3(1.0), kFarthest, 0.0, vec3(0.0));

/// What a voxel of glass lets through; glass is tinted by its colour, not by how dark that is.
vec3 transmittance(int body, Layout shape, int index, int slot, ivec3 cell) {
    Entry entry = readEntry(shape.palette, index);
    vec3 linear = pow(paintedColor(body, shape, slot, cell, entry.color), vec3(2.2));
    vec3 hue = linear / max(max(linear.r, linear.g), max(linear.b, 0.01));
    return (1.0 - entry.opacity) * mix(vec3(1.0), hue, 0.7);
}

/// Up to the first opaque voxel, or tMax.
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
            panes.normal = w.axis == ivec3(0) ? -normalize(rayCells) : vec3(w.axis * (1 - 2 * w.ahead));
        }
        panes.last = w.t;
        leaveBlock(w, 1);
        if (!(w.t < tMax) || !insideCells(w.cell, shape.low, shape.high)) break;
    }
    return panes;
}
