// Which bodies a pixel has to look at, nearest first (filled by render/scene/body_tiles.cpp).
#include "lib/bodies.glsl"
uniform usamplerBuffer uTileOffsets;  // of each tile, in uTileBodies; the list ends where the next tile's begins
uniform usamplerBuffer uTileBodies;  // numbers of views
uniform usamplerBuffer uBodyViews;   // 5 texels a body in view
uniform ivec2 uTileGrid;             // tiles in a row; log2 of a tile's pixels

struct BodyView {
    float nearest;        // no voxel of it is nearer: metres along the view axis
    int instance;
    vec3 camera, ray;     // in its cells; the ray has 1 along the view axis
    Layout shape;
};

/// First and end of a pixel's list.
ivec2 tileList(ivec2 pixel) {
    ivec2 tile = pixel >> uTileGrid.y;
    int i = tile.y * uTileGrid.x + tile.x;
    return ivec2(texelFetch(uTileOffsets, i).r, texelFetch(uTileOffsets, i + 1).r);
}

/// The body of an entry as the ray through a point of the screen (in pixels) meets it.
BodyView bodyViewAt(int entry, vec2 screen) {
    int i = int(texelFetch(uTileBodies, entry).r) * 5;
    uvec4 a = texelFetch(uBodyViews, i), b = texelFetch(uBodyViews, i + 1), c = texelFetch(uBodyViews, i + 2), d = texelFetch(uBodyViews, i + 3);
    uvec4 e = texelFetch(uBodyViews, i + 4);
    vec3 ray = uintBitsToFloat(b.xyz) + uintBitsToFloat(c.xyz) * screen.x + uintBitsToFloat(d.xyz) * screen.y;
    Layout shape = Layout(int(c.w), int(d.w >> 8), d.w & 255u, (ivec3(e.w) >> ivec3(0, 10, 20)) & 1023, ivec3(e.xyz & 65535u), ivec3(e.xyz >> 16));
    return BodyView(uintBitsToFloat(a.w), int(b.w), uintBitsToFloat(a.xyz), ray, shape);
}
