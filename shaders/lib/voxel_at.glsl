// The voxel at a point of the world (filled by render/scene/body_grid.cpp). Needs lib/voxel_walk, paint.
uniform usamplerBuffer uBodyFirsts;   // a bucket: number of its first entry plus one, 0 = none
uniform usamplerBuffer uBodyEntries;  // body, number of the next entry plus one
uniform int uBodyBuckets;  // a power of two
uniform int uBodyLevels;   // 0 = no body anywhere

const float kFinestBodyCell = 1.6;  // metres
const int kMostBodiesAt = 128;  // that are looked into

uint firstBodyAt(vec3 world, int level) {
    uvec3 c = uvec3(ivec3(floor(world / (kFinestBodyCell * float(1 << (2 * level))))));
    uint hash = c.x * 0x8da6b343u ^ c.y * 0xd8163841u ^ c.z * 0xcb1ab31fu ^ uint(level) * 0x9e3779b9u;
    hash ^= hash >> 15;
    return texelFetch(uBodyFirsts, int(hash & uint(uBodyBuckets - 1))).r;
}

/// Its palette entry, painted, if an opaque voxel is there.
bool voxelAt(vec3 world, out Entry entry) {
    uint next = 0u;
    int level = 0;
    for (int i = 0; i < kMostBodiesAt; ++i) {
        if (next == 0u) {
            if (level == uBodyLevels) break;
            next = firstBodyAt(world, level++);
            continue;
        }
        uvec2 listed = texelFetch(uBodyEntries, int(next) - 1).rg;
        next = listed.y;
        int body = int(listed.x);
        Layout shape = readLayout(body);
        vec4 place = texelFetch(uPlacements, body * 4 + 1);
        ivec3 cell = ivec3(floor(rotateBack(texelFetch(uPlacements, body * 4), world - place.xyz) / place.w));
        int slot;
        if (!insideCells(cell, shape.low, shape.high) || emptySizeAt(shape, cell, slot) > 0) continue;
        entry = readEntry(shape.palette, indexAt(slot, cell));
        if (entry.opacity < 1.0) continue;
        entry.color = paintedColor(body, shape, slot, cell, entry.color);
        return true;
    }
    return false;
}
