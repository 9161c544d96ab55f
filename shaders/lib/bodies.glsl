// The buffers of all bodies (filled by render/scene/bodies.cpp) and the meaning of their texels. A shape is a grid of
// nodes of 32^3 cells; a node holds 4^3 bricks of 8^3 cells; a brick holds 2^3 words of 4^3 cells, one bit a cell.
#include "lib/constants.glsl"
#include "lib/texels.glsl"
uniform texels4 uNodes;         // a node: 64-bit mask of its bricks, number of its brick table
uniform texels1 uTables;        // 64 texels a table: brick slot << 8 | mask of the brick's occupied words
uniform texels2 uBrickWords;    // 8 texels a brick: its words, 64 bits each
uniform texels1 uBrickIndices;  // 128 texels a brick: 512 palette indices, four a texel
uniform texels4f uTransforms;   // 4 texels an instance: see readTransform()
uniform texels4 uLayouts;       // 4 texels an instance: first node, palette, flags; nodes; low cell; high cell
uniform texels4 uPalettes;      // 256 texels a palette: colour and opacity, surface, emission, detail map

uvec4 fetchNode(int i) { return fetch4(uNodes, i); }
uint fetchTable(int i) { return fetch1(uTables, i); }
uvec2 fetchWord(int i) { return fetch2(uBrickWords, i); }
uint fetchIndices(int i) { return fetch1(uBrickIndices, i); }

/// Where an instance is in this frame and was in the previous one.
struct InstanceTransform {
    vec4 rotation;    // quaternion, body -> world
    vec3 position;    // of the corner of cell 0, world
    float voxelSize;  // metres
    vec4 lastRotation;
    vec3 lastPosition;
    float moved;  // 1 if it differs from the previous frame's
};

InstanceTransform readTransform(int instance) {
    vec4 p = fetch4f(uTransforms, instance * 4 + 1), q = fetch4f(uTransforms, instance * 4 + 3);
    return InstanceTransform(fetch4f(uTransforms, instance * 4), p.xyz, p.w,
                             fetch4f(uTransforms, instance * 4 + 2), q.xyz, q.w);
}

/// The voxels of an instance: its nodes, and the box [low, high) of its occupied cells.
struct Layout {
    int node, palette;
    uint flags;
    ivec3 sizeInNodes, low, high;
};

Layout readLayout(int instance) {
    uvec4 a = fetch4(uLayouts, instance * 4);
    return Layout(int(a.x), int(a.y), a.z, ivec3(fetch4(uLayouts, instance * 4 + 1).xyz),
                  ivec3(fetch4(uLayouts, instance * 4 + 2).xyz), ivec3(fetch4(uLayouts, instance * 4 + 3).xyz));
}

/// The node that holds a cell.
uvec4 nodeAt(Layout body, ivec3 cell) {
    ivec3 node = cell >> 5;
    return fetchNode(body.node + node.x + body.sizeInNodes.x * (node.y + body.sizeInNodes.y * node.z));
}

/// Number of a cell's word in its brick.
int wordOf(ivec3 cell) { return (cell.x >> 2 & 1) + (cell.y >> 2 & 1) * 2 + (cell.z >> 2 & 1) * 4; }

/// Which of the 128 texels of its brick holds a voxel's byte, and the byte.
int texelOf(ivec3 cell) {
    ivec3 c = cell & 7;
    return (c.x >> 2) + c.y * 2 + c.z * 16;
}
uint byteOf(uint texel, ivec3 cell) { return (texel >> uint((cell.x & 3) * 8)) & 255u; }

/// A palette entry: the material of a voxel.
struct Entry {
    vec3 color;  // sRGB
    float opacity, roughness, metallic, reflectivity, emission;
    uint detail;  // number of its detail map, 0 = none
};

Entry readEntry(int palette, int index) {
    uvec4 v = fetch4(uPalettes, palette * 256 + index);
    uvec4 bytes = uvec4(0u, 8u, 16u, 24u);
    vec4 a = vec4((uvec4(v.x) >> bytes) & 255u) / 255.0, b = vec4((uvec4(v.y) >> bytes) & 255u) / 255.0;
    return Entry(a.rgb, a.a, b.r, b.g, b.b, uintBitsToFloat(v.z), v.w);
}

/// Glass is what has an opacity below 255.
bool isGlass(int palette, int index) { return fetch4(uPalettes, palette * 256 + index).x >> 24 < 255u; }

/// A vector rotated by a unit quaternion, and by its inverse.
vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
vec3 rotateBack(vec4 q, vec3 v) { return rotate(vec4(-q.xyz, q.w), v); }
