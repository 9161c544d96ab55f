// The bodies that a pixel may show, nearest first: one list for each tile of pixels (filled by
// render/scene/body_tiles.cpp).
#include "lib/bodies.glsl"
uniform texels1 uTileOffsets;  // a tile: its first entry in uTileBodies; its list ends where the next begins
uniform texels1 uTileBodies;   // an entry: the number of a body view
uniform texels4 uBodyViews;    // 5 texels a body in view
uniform ivec2 uTileGrid;       // tiles in a row; log2 of a tile's side in pixels

/// A body and the ray of a pixel in the body's cells.
struct BodyView {
    int instance;
    vec3 camera, ray;  // in cells; the ray has a length of 1 along the view axis
    Layout shape;
};

/// First entry and end of the list of a pixel's tile.
ivec2 tileList(ivec2 pixel) {
    ivec2 tile = pixel >> uTileGrid.y;
    int i = tile.y * uTileGrid.x + tile.x;
    return ivec2(fetch1(uTileOffsets, i), fetch1(uTileOffsets, i + 1));
}

/// Whether an entry of a list that ends at `end` may show something nearer than t, metres along the view axis: as no
/// later one does if it does not.
bool isNearer(int entry, int end, float t) {
    return entry < end && uintBitsToFloat(fetch4(uBodyViews, int(fetch1(uTileBodies, entry)) * 5).w) < t;
}

/// The body of a list entry, with the ray through a point of the screen (in pixels). Rays in a body's cells are linear
/// in the point, so the one of the lower left corner and two derivatives are stored, without jitter: of its direction,
/// or of where it begins in an orthographic view. Needs lib/frame.
BodyView bodyViewAt(int entry, vec2 screen) {
    int i = int(fetch1(uTileBodies, entry)) * 5;
    uvec4 a = fetch4(uBodyViews, i), b = fetch4(uBodyViews, i + 1), c = fetch4(uBodyViews, i + 2),
          d = fetch4(uBodyViews, i + 3);
    uvec4 e = fetch4(uBodyViews, i + 4);
    screen += frame.jitter.xy * frame.targetSize.xy;
    vec3 start = uintBitsToFloat(a.xyz), ray = uintBitsToFloat(b.xyz), stepX = uintBitsToFloat(c.xyz),
         stepY = uintBitsToFloat(d.xyz);
    if (isOrthographic()) start = start + stepX * screen.x + stepY * screen.y;
    else ray = ray + stepX * screen.x + stepY * screen.y;
    Layout shape = Layout(int(c.w), int(d.w >> 8), d.w & 255u, (ivec3(e.w) >> ivec3(0, 10, 20)) & 1023,
                          ivec3(e.xyz & 65535u), ivec3(e.xyz >> 16));
    return BodyView(int(b.w), start, ray, shape);
}
