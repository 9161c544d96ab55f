// The first voxel of one body on a ray: the walk of lib/cell_walk.glsl down a tree of bit masks. Nodes have 32^3 cells,
// bricks 8^3, words 4^3. At each step the masks say how large the empty block around the present cell is (32, 16, 8, 4,
// 2 or 1 cells a side), and the ray leaves it in one go. The walk is exact: no cell on the ray is left out.
#include "lib/bodies.glsl"
#include "lib/cell_walk.glsl"

// What a walk stops at.
const int kStopAtSolid = 0;   // any voxel
const int kStopAtOpaque = 1;  // voxels of opacity 255
const int kStopAtGlass = 2;   // voxels of lower opacity

const int kMaxSteps = 8192;

struct VoxelHit {
    bool hit;
    ivec3 cell;
    int index;    // palette entry
    int slot;     // of its brick
    float t;      // in lengths of the direction
    vec3 normal;  // of the face that was entered through, in the body; 0 if the ray begins inside the voxel
    int steps;
    float glassT;  // of the first voxel of glass before it; tMax or more if there is none
};

/// Palette index of a voxel. slot: of its brick.
int indexAt(int slot, ivec3 cell) { return int(byteOf(fetchIndices(slot * 128 + texelOf(cell)), cell)); }

/// Side of the empty block that holds a cell; 0 if the cell is solid. slot: of a solid cell's brick.
int emptySizeAt(Layout body, ivec3 cell, out int slot) {
    slot = 0;
    uvec4 n = nodeAt(body, cell);
    if ((n.x | n.y) == 0u) return 32;
    int empty = emptyChildren(n.xy, cell >> 3);
    if (empty != 0) return empty * 8;
    uint entry = fetchTable(int(n.z) * 64 + childOf(cell >> 3));
    int word = wordOf(cell);
    if ((entry >> uint(word) & 1u) == 0u) return 4;
    slot = int(entry >> 8);
    return emptyChildren(fetchWord(slot * 8 + word), cell);
}

/// Walks on to the first solid cell, the present one included. False if there is none up to tMax. It goes as
/// leaveBlock() does, but mirrored so that the ray goes up on all axes, and with only what each step needs in the loop.
bool findSolid(inout CellWalk w, Layout body, float tMax, out int slot, inout int steps) {
    ivec3 flip = w.ahead - 1;  // 0 where the ray goes up, ~0 where it goes down
    vec3 stepSign = vec3(2 * w.ahead - 1);
    vec3 origin = w.origin * stepSign, direction = w.direction * stepSign, inverse = w.inverse * stepSign;
    ivec3 last = ivec3(flip.x == 0 ? body.high.x - 1 : ~body.low.x, flip.y == 0 ? body.high.y - 1 : ~body.low.y,
                       flip.z == 0 ? body.high.z - 1 : ~body.low.z);
    ivec3 cell = w.cell ^ flip;
    float t = w.t;
    bool found = false;
    int i = 0;
    for (; i < kMaxSteps; ++i) {
        int size = emptySizeAt(body, cell ^ flip, slot);
        found = size == 0;
        ivec3 high = cell | (size - 1);
        vec3 leave = (vec3(high + 1) - origin) * inverse + w.never;
        float next = leave.y < leave.z ? leave.y : leave.z;
        next = leave.x < next ? leave.x : next;
        ivec3 to = max(cell, min(ivec3(floor(origin + direction * next)), high));
        bool x = leave.x <= next, y = !x && leave.y <= next;
        to.x = x ? high.x + 1 : to.x;
        to.y = y ? high.y + 1 : to.y;
        to.z = x || y ? to.z : high.z + 1;
        if (found || !(next <= tMax) || any(greaterThan(to, last))) break;
        cell = to;
        t = next;
    }
    if (i > 0) {
        vec3 enter = (vec3(cell) - origin) * inverse - w.never;
        w.axis = enter.x >= max(enter.y, enter.z) ? ivec3(1, 0, 0)
                 : enter.y >= enter.z             ? ivec3(0, 1, 0)
                                                  : ivec3(0, 0, 1);
    }
    steps += i + 1;
    w.cell = cell ^ flip;
    w.t = t;
    return found;
}

/// originCells and direction in the body's cells; tMin and tMax in lengths of the direction.
VoxelHit walkVoxels(Layout body, vec3 originCells, vec3 direction, float tMin, float tMax, int stopAt) {
    VoxelHit result = VoxelHit(false, ivec3(0), 0, 0, tMax, vec3(0.0), 0, kFarthest);
    CellWalk w;
    if (isnan(tMax)) return result;
    tMax = min(tMax, kFarthest);
    if (!startWalk(w, originCells, direction, tMin, tMax, body.low, body.high)) return result;
    bool plain = stopAt == kStopAtSolid || (stopAt == kStopAtOpaque && (body.flags & kHasGlass) == 0u);
    // findSolid() is a loop of its own: all lanes of a GPU pay for the whole body of a loop in each step.
    for (int i = 0; i < kMaxSteps; ++i) {
        int slot;
        if (!findSolid(w, body, tMax, slot, result.steps)) break;
        int index = indexAt(slot, w.cell);
        if (plain || isGlass(body.palette, index) == (stopAt == kStopAtGlass)) {
            vec3 outward = vec3(1 - 2 * w.ahead);
            return VoxelHit(true, w.cell, index, slot, max(w.t, 0.0), vec3(w.axis) * outward, result.steps,
                            result.glassT);
        }
        result.glassT = min(result.glassT, w.t);
        leaveBlock(w, 1);
        if (!(w.t <= tMax) || !insideCells(w.cell, body.low, body.high)) break;
    }
    return result;
}
