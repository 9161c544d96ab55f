// Exact rays through the world's shadow volume (filled by render/scene/shadow_mirror.cpp): sectors of 64^3 cells, bricks of
// 16^3, words of 4^3, cells of 0.1 m. Whatever is empty is leapt. Needs lib/frame.glsl first.
#include "lib/cell_walk.glsl"

uniform usamplerBuffer uShadowSectors;  // a sector: 64-bit mask of its bricks, number of its table
uniform usamplerBuffer uShadowTables;   // 64 texels a table: slot of the brick, -, 64-bit mask of its words
uniform usamplerBuffer uShadowBricks;   // 64 texels a brick: a word of 4x4x4 cells each

const float kShadowCell = 0.1;  // metres

// All fetches go through here: WebGL2 has no buffer textures and will read 2D ones.
uvec4 fetchShadowSector(int i) { return texelFetch(uShadowSectors, i); }
uvec4 fetchShadowTable(int i) { return texelFetch(uShadowTables, i); }
uvec2 fetchShadowBrick(int i) { return texelFetch(uShadowBricks, i).rg; }

// Side of the empty block that holds a cell of the directory; 0 if the cell is occupied.
int shadowEmptySize(ivec3 cell, ivec3 sectors) {
    ivec3 s = cell >> 6;
    uvec4 sector = fetchShadowSector(s.x + sectors.x * (s.y + sectors.y * s.z));
    if ((sector.x | sector.y) == 0u) return 64;
    int empty = emptyChildren(sector.xy, cell >> 4);
    if (empty != 0) return empty * 16;
    uvec4 entry = fetchShadowTable(int(sector.z) * 64 + childOf(cell >> 4));
    empty = emptyChildren(entry.zw, cell >> 2);
    if (empty != 0) return empty * 4;
    return emptyChildren(fetchShadowBrick(int(entry.x) * 64 + childOf(cell >> 2)), cell);
}

// A point of the world (from the render origin) in the directory's cells.
vec3 shadowCells(vec3 positionWorld) { return positionWorld / kShadowCell - vec3(frame.shadowSectorLow.xyz * 64); }

// True if the ray from originWorld (metres, from the render origin) meets an occupied cell within tMax metres along the unit
// vector `direction`; t is where. An origin in an occupied cell is a hit at 0: see shadowOrigin().
bool shadowTrace(vec3 originWorld, vec3 direction, float tMax, out float t) {
    t = tMax;
    ivec3 sectors = frame.shadowSectorCount.xyz;
    ivec3 high = sectors * 64;
    CellWalk w;
    float tMaxCells = tMax / kShadowCell;
    if (!startWalk(w, shadowCells(originWorld), direction, 0.0, tMaxCells, ivec3(0), high)) return false;
    for (int i = 0; i < 4096; ++i) {
        int size = shadowEmptySize(w.cell, sectors);
        if (size == 0) {
            t = max(w.t, 0.0) * kShadowCell;
            return true;
        }
        leaveBlock(w, size);
        if (!(w.t <= tMaxCells) || !insideCells(w.cell, ivec3(0), high)) return false;
    }
    return false;
}

// THE rule for leaving one's own surface. A body sets the cells whose centres lie in it. A face along the grid therefore ends in
// the cells at the boundary nearest to it: the ray starts there, exactly. The cells of a turned body reach up to half a cell's
// extent along the normal out of its faces, vec3(1) dot |normal| being 1 to 1.73 cells: from there (and a hair) a ray that does
// not go down never meets them, however the body is turned.
const float kLeaveCells = 0.52;
vec3 shadowOrigin(vec3 positionWorld, vec3 normalWorld) {
    vec3 along = abs(normalWorld);
    float cells = kLeaveCells * dot(along, vec3(1.0));
    if (max(along.x, max(along.y, along.z)) > 0.9999) {
        float height = dot(positionWorld, normalWorld) / kShadowCell;
        cells = ceil(height - 0.499) + 0.01 - height;
    }
    return positionWorld + normalWorld * (cells * kShadowCell);
}
