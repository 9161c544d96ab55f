// The voxel at a point of the world, found with a hierarchical hash grid of bodies (filled by
// render/scene/body_grid.cpp; Ericson 2004, "Real-Time Collision Detection", 7.2). A body is listed in the few cells
// that its box touches, at the level whose cells are about as large as the body. So a point asks one bucket of each
// level and looks into the bodies listed there. Needs lib/voxel_walk, paint.
#include "lib/constants.glsl"
#include "lib/texels.glsl"
uniform texels1 uBodyBucketHeads;  // a bucket: number of its first entry plus one, 0 = none
uniform texels2 uBodyEntries;      // an entry: body, number of the next entry plus one
uniform int uBodyBuckets;          // a power of two
uniform int uBodyLevels;           // 0 = no bodies

const int kMaxBodiesPerPoint = 128;  // no more are looked into

/// First entry of the bucket for a point's cell at a level.
uint firstBodyAt(vec3 world, int level) {
    uvec3 c = uvec3(ivec3(floor(world / (kFinestBodyCell * float(1 << (2 * level))))));
    uint hash = c.x * 0x8da6b343u ^ c.y * 0xd8163841u ^ c.z * 0xcb1ab31fu ^ uint(level) * 0x9e3779b9u;
    hash ^= hash >> 15;
    return fetch1(uBodyBucketHeads, int(hash & uint(uBodyBuckets - 1)));
}

/// Whether a body has a voxel in a cell. slot: of the voxel's brick.
bool solidAt(Layout body, ivec3 cell, out int slot) {
    uvec4 n = nodeAt(body, cell);
    int brick = childOf(cell >> 3), word = wordOf(cell), child = childOf(cell);
    bool filled = ((brick < 32 ? n.x : n.y) >> uint(brick & 31) & 1u) != 0u;
    uint entry = filled ? fetchTable(int(n.z) * 64 + brick) : 0u;
    slot = int(entry >> 8);
    uvec2 cells = (entry >> uint(word) & 1u) != 0u ? fetchWord(slot * 8 + word) : uvec2(0u);
    return ((child < 32 ? cells.x : cells.y) >> uint(child & 31) & 1u) != 0u;
}

struct BodySearch {
    uint next;        // entry plus one
    int level, left;  // next level; bodies that may still be looked into
};
/// The next body whose box holds a point, and the point's cell in it; -1 if there are no more.
int nextBodyAt(inout BodySearch search, vec3 world, out ivec3 cell) {
    int body = -1;
    do {
        do {
            if (search.next != 0u || search.level >= uBodyLevels) break;
            search.next = firstBodyAt(world, search.level++);
        } while (search.next == 0u && search.level < uBodyLevels);
        if (search.next == 0u || search.left == 0) break;
        uvec2 listed = fetch2(uBodyEntries, int(search.next) - 1);
        int candidate = int(listed.x);
        vec4 place = fetch4f(uTransforms, candidate * 4 + 1);
        cell = ivec3(floor(rotateBack(fetch4f(uTransforms, candidate * 4), world - place.xyz) / place.w));
        ivec3 low = ivec3(fetch4(uLayouts, candidate * 4 + 2).xyz),
              high = ivec3(fetch4(uLayouts, candidate * 4 + 3).xyz);
        if (insideCells(cell, low, high)) body = candidate;
        search.next = listed.y;
        --search.left;
    } while (body < 0);
    return body;
}

/// The painted palette entry of the opaque voxel at a point; false if there is none.
bool voxelAt(vec3 world, out Entry entry) {
    BodySearch search = BodySearch(0u, 0, kMaxBodiesPerPoint);
    // The search is a loop of its own: all lanes of a GPU pay for the whole body of a loop in each step.
    for (;;) {
        ivec3 cell;
        int slot, body = nextBodyAt(search, world, cell);
        if (body < 0) return false;
        Layout shape = readLayout(body);
        if (!solidAt(shape, cell, slot)) continue;
        int index = indexAt(slot, cell);
        if ((shape.flags & kHasGlass) != 0u && isGlass(shape.palette, index)) continue;
        entry = readEntry(shape.palette, index);
        entry.color = paintedColor(body, shape, slot, cell, entry.color);
        return true;
    }
}
