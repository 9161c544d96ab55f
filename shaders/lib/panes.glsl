// A ray through the glass of one body. Needs lib/frame, voxel_walk, paint.
struct Panes {
    bool any;
    vec3 tint;    // share of the light that comes through all of them
    float first, last;  // where the ray meets the nearest and the farthest, in lengths of its direction
    vec3 normal;  // of the nearest, in the body
};

/// What a voxel of glass lets through; glass is tinted by its colour, not by how dark that is.
vec3 transmittance(int body, Layout shape, int index, int slot, ivec3 cell) {
    Entry entry = readEntry(shape.palette, index);
    vec3 linear = pow(paintedColor(body, shape, slot, cell, entry.color), vec3(2.2));
    vec3 hue = linear / max(max(linear.r, linear.g), max(linear.b, 0.01));
    return (1.0 - entry.opacity) * mix(vec3(1.0), hue, 0.7);
}

/// Up to the first opaque voxel, or tMax.
Panes throughPanes(int body, Layout shape, vec3 originCells, vec3 rayCells, float tMax) {
    Panes panes = Panes(false, vec3(1.0), 0.0, 0.0, vec3(0.0));
    CellWalk w;
    if (!startWalk(w, originCells, rayCells, 0.0, tMax, shape.low, shape.high)) return panes;
    bool inPane = false;  // neighbouring cells of glass are one pane
    for (int i = 0; i < 8192; ++i) {
        int slot;
        int size = emptySizeAt(shape, w.cell, slot);
        bool glass = false;
        if (size == 0) {
            int index = indexAt(slot, w.cell);
            glass = isGlass(shape.palette, index);
            if (!glass) break;
            if (!inPane) panes.tint *= transmittance(body, shape, index, slot, w.cell);
            panes.last = w.t;
            if (!panes.any) {
                vec3 outward = vec3(w.axis) * vec3(1 - 2 * w.ahead);
                panes.normal = outward == vec3(0.0) ? -normalize(rayCells) : outward;
                panes.first = w.t;
                panes.any = true;
            }
            size = 1;
        }
        inPane = glass;
        leaveBlock(w, size);
        if (!(w.t < tMax) || !insideCells(w.cell, shape.low, shape.high)) break;
    }
    return panes;
}
