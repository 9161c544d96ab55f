// The paint layer of bodies (filled by render/scene/paint_atlas.cpp), for shapes that have paint. Needs lib/bodies.
uniform texels1 uPaintSlots;  // a texel a brick: its number in uPaint plus one, 0 = unpainted
uniform texels1 uPaint;       // 128 texels a painted brick, a byte a voxel: colour << 4 | steps - 1; 0 = unpainted
uniform texels1 uPaintColors;  // 16 texels a shape: sRGB colours 1 to 15

/// Colour (sRGB) of a voxel: its material's colour, mixed with its paint by steps of a sixteenth. The same as
/// paintOver() in runtime/voxel/paint_colors.h. slot: of the voxel's brick.
vec3 paintedColor(int body, Layout shape, int slot, ivec3 cell, vec3 color) {
    if ((shape.flags & kHasPaint) == 0u) return color;
    uint brick = fetch1(uPaintSlots, slot);
    if (brick == 0u) return color;
    uint paint = byteOf(fetch1(uPaint, int(brick - 1u) * 128 + texelOf(cell)), cell);
    if (paint == 0u) return color;
    uint table = fetch1(uPaintColors, body * 16 + int(paint >> 4));
    vec3 over = vec3((uvec3(table) >> uvec3(0u, 8u, 16u)) & 255u) / 255.0;
    return mix(color, over, float((paint & 15u) + 1u) / 16.0);
}
