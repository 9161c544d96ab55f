// Exact rays through the world's shadow volume (filled by render/scene/gpu_shadow_volume.cpp): bricks of 16^3 cells of
// 0.1 m, each of 4^3 words of 4^3 cells (one bit a cell). It is a grid walk as in lib/cell_walk.glsl, with empty space
// skipped. Each step leaves the largest block around the present cell that is known to be empty ahead of the ray:
//   - a box of up to 8^3 empty bricks, stored for each octant of directions in the empty brick (like the distance to
//     the nearest obstacle in Cohen and Sheffer 1994, but by octant);
//   - outside of the level's box a cube of empty sectors (4^3 bricks), stored by octant in the empty sector;
//   - in an occupied brick, a box of empty words, stored by octant in the empty word itself;
//   - the rest of a word, if none of its cells ahead of the ray is occupied;
//   - an aligned 2x2x2 of empty cells, or one cell.
// The ray is mirrored so that it goes up on every axis: cell c of a mirrored axis is cell size - 1 - c of the volume.
// Then a step is the same for all octants: the planes that bound a block are those above it, the ray crosses the
// nearest one, and the number of a word or cell is mirrored with one XOR. All branches are selections, as lanes of a
// GPU wait for each other anyway. Needs lib/frame first.
#include "lib/constants.glsl"
#include "lib/texels.glsl"

// The directory (render/scene/shadow_directory.h) has two parts, through which a ray goes one after the other. The
// dense part, the level's box, has a texel a brick. Empty brick: x 1; yzw the sides of the empty boxes, 4 bits an
// octant. Occupied brick: x its first texel in uShadowTexels, a multiple of 16; y and z which of its words are
// occupied. Behind them are the pages of the paged part, which holds what is outside of that box: 64 such texels each.
uniform texels4 uShadowBricks;
// The paged part's table: a texel a sector. Empty sector: the sides of the empty cubes, 4 bits an octant. Occupied
// sector: the first texel of its page, a multiple of 16.
uniform texels1 uShadowTable;
// 64 texels a brick: the cells of an occupied word, or the empty boxes of an empty one
// (runtime/shadow/shadow_volume.h).
uniform texels2 uShadowTexels;

uvec4 fetchShadowBrick(int i) { return fetch4(uShadowBricks, i); }
uint fetchShadowTable(int i) { return fetch1(uShadowTable, i); }
uvec2 fetchShadowTexel(int i) { return fetch2(uShadowTexels, i); }

const float kAlwaysExact = 1.0e30;

/// A part of the directory. In sectors from the render origin, and the box of its occupied cells in cells from there.
struct ShadowPart {
    ivec3 first, sectors;
    vec3 low, high;
};
ShadowPart shadowPart(bool isPaged) {
    if (isPaged)
        return ShadowPart(frame.shadowPagedFirst.xyz, frame.shadowPagedSize.xyz, frame.shadowPagedLow.xyz,
                          frame.shadowPagedHigh.xyz);
    return ShadowPart(frame.shadowDenseFirst.xyz, frame.shadowDenseSize.xyz, frame.shadowDenseLow.xyz,
                      frame.shadowDenseHigh.xyz);
}

/// A mirrored ray, clipped to the box of a part's occupied cells. Everything in cells.
struct ShadowRay {
    bvec3 isDown;                     // the axes that are mirrored
    vec3 origin, direction, inverse;  // the direction's components are above 0
    float begin, end;
    ivec3 cell;  // at begin
};

/// False if the ray misses all occupied cells, or is NaN.
bool startShadowRay(ShadowPart part, vec3 originWorld, vec3 direction, float tMax, out ShadowRay ray) {
    ray.isDown = lessThan(direction, vec3(0.0));
    vec3 size = vec3(part.sectors * 64);
    ray.direction = max(abs(direction), vec3(1.0e-20));
    vec3 origin = originWorld * kShadowCellsPerMetre - vec3(part.first * 64);
    ray.origin = mix(origin, size - origin, ray.isDown);
    ray.inverse = 1.0 / ray.direction;
    vec3 low = mix(part.low, size - part.high, ray.isDown), high = mix(part.high, size - part.low, ray.isDown);
    vec3 enter = (low - ray.origin) * ray.inverse, leave = (high - ray.origin) * ray.inverse;
    ray.begin = max(max(enter.x, enter.y), max(enter.z, 0.0));
    float end = tMax * kShadowCellsPerMetre;
    end = leave.x < end ? leave.x : end;
    end = leave.y < end ? leave.y : end;
    ray.end = leave.z < end ? leave.z : end;
    if (!(ray.begin < ray.end)) return false;
    ray.cell = clamp(ivec3(ray.origin + ray.direction * ray.begin), ivec3(low), ivec3(high) - 1);
    return true;
}

/// Which cells of a word are ahead of a ray: those at or beyond its cell on every axis.
struct AheadMasks {
    uint columns, slices;
    int rowsTurned, rowsFirst;
};

AheadMasks aheadMasks(bvec3 isDown) {
    int down = int(isDown.y);
    return AheadMasks(isDown.x ? 0x137fu : 0x8cefu, isDown.z ? 0xffffu : 0xffff0000u, down - 1, 13 - down);
}

/// Whether no occupied cell of a word is ahead of a cell. nearHalf: the half of the word that holds the cell.
bool nothingAheadOf(ivec3 cell, uint nearHalf, uint farHalf, AheadMasks ahead) {
    uint columns = (ahead.columns >> uint((cell.x & 3) << 2) & 15u) * 0x11111111u;
    uint rows = (0x0ffff000u >> uint(ahead.rowsFirst + ((cell.y & 3) << 2 ^ ahead.rowsTurned)) & 0xffffu) * 0x10001u;
    uint slices = (nearHalf & ((cell.z & 1) == 0 ? 0xffffffffu : ahead.slices)) | ((cell.z & 2) == 0 ? farHalf : 0u);
    return (slices & rows & columns) == 0u;
}

/// The walk through one part of the directory: see shadowTraceCoarse().
bool walkShadowPart(bool isPaged, vec3 originWorld, vec3 direction, float tMax, float exactDistance, out float t) {
    t = tMax;
    bool coarse = exactDistance < kAlwaysExact;  // known at compile time
    exactDistance *= kShadowCellsPerMetre;
    ShadowPart part = shadowPart(isPaged);
    ShadowRay ray;
    if (!startShadowRay(part, originWorld, direction, tMax, ray)) return false;
    ivec3 size = isPaged ? part.sectors : part.sectors * 4, pitch = ivec3(1, size.x, size.x * size.y);
    ivec3 farthest = pitch * (size - 1);
    int first =
        (ray.isDown.x ? farthest.x : 0) + (ray.isDown.y ? farthest.y : 0) + (ray.isDown.z ? farthest.z : 0);
    pitch =
        ivec3(ray.isDown.x ? -pitch.x : pitch.x, ray.isDown.y ? -pitch.y : pitch.y, ray.isDown.z ? -pitch.z : pitch.z);
    ivec3 down = ivec3(ray.isDown);
    int turned =
        3 * (down.x + 4 * down.y + 16 * down.z);  // mirrors the number of a word in its brick or a cell in its word
    int octant = down.x + 2 * down.y + 4 * down.z;
    uint sideShift = uint(octant * 4), boxShift = uint(octant * 2);
    AheadMasks ahead = aheadMasks(ray.isDown);
    ivec3 cell = ray.cell;
    float current = ray.begin;
    bool stopped = false;
    do {
        t = current;
        ivec3 place = isPaged ? cell >> 6 : cell >> 4;  // of a sector, or of a brick
        int index = first + place.x * pitch.x + place.y * pitch.y + place.z * pitch.z;
        uint page = isPaged ? fetchShadowTable(index) : 0u;
        bool emptySector = (page & 15u) != 0u;
        int word = ((cell.x >> 2 & 3) | (cell.y & 12) | (cell.z & 12) << 2) ^ turned;
        int inPage = ((cell.x >> 4 & 3) | (cell.y >> 2 & 12) | (cell.z & 48)) ^ turned;
        uvec4 brick = fetchShadowBrick(!isPaged ? index : emptySector ? 0 : int(page) + inPage);
        bool emptyBrick = emptySector || (brick.x & 15u) != 0u;  // or sector
        bool emptyWord = emptyBrick || ((word < 32 ? brick.y : brick.z) >> uint(word & 31) & 1u) == 0u;
        uvec2 texel = fetchShadowTexel(emptyBrick ? 0 : int(brick.x) + word);
        int inWord = ((cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4) ^ turned;
        uint nearHalf = inWord < 32 ? texel.x : texel.y, farHalf = inWord < 32 ? texel.y : texel.x;
        stopped = !emptyWord && ((nearHalf >> uint(inWord & 31) & 1u) != 0u || (coarse && current > exactDistance));
        bool nothingAhead = emptyWord || nothingAheadOf(cell, nearHalf, farHalf, ahead);
        bool emptyEight = (nearHalf >> uint(inWord & 10) & 0x00330033u) == 0u;  // the aligned 2x2x2 cells around it
        ivec3 box = ivec3(uvec3(texel.x >> boxShift, texel.x >> (boxShift + 16u), texel.y >> boxShift) & 3u) + 1;
        // The block is `skip` units a side, of 2^unit cells each.
        uvec3 sides = (emptySector ? uvec3(page) : brick.yzw) >> sideShift & 15u;
        ivec3 skip = emptyBrick ? ivec3(sides) : emptyWord ? box : ivec3(1);
        int unit = emptySector ? 6 : emptyBrick ? 4 : nothingAhead ? 2 : emptyEight ? 1 : 0;
        ivec3 plane = ((cell >> unit) + skip) << unit;
        vec3 leave = (vec3(plane) - ray.origin) * ray.inverse;
        float next = leave.y < leave.z ? leave.y : leave.z;
        next = leave.x < next ? leave.x : next;
        ivec3 beside =
            clamp(ivec3(ray.origin + ray.direction * next), cell, plane - 1);  // never back: a point is rounded
        // Across one plane at a time: a ray through an edge visits a cell beside it and never slips between two.
        bool acrossX = leave.x <= next, acrossY = !acrossX && leave.y <= next;
        cell =
            ivec3(acrossX ? plane.x : beside.x, acrossY ? plane.y : beside.y, acrossX || acrossY ? beside.z : plane.z);
        current = next;
    } while (!stopped && current < ray.end);
    t = stopped ? t * kShadowCell : tMax;
    return stopped;
}

/// True if the ray from originWorld (metres, from the render origin) meets an occupied cell within tMax metres along
/// the unit vector `direction`; t is the distance. An origin in an occupied cell is a hit at 0: see surfaceOrigin().
/// Beyond exactDistance metres any word with an occupied cell stops the ray: too much shadow there, never too little.
bool shadowTraceCoarse(vec3 originWorld, vec3 direction, float tMax, float exactDistance, out float t) {
#ifdef NO_PAGED_SHADOWS  // see ShaderLibrary::setRareFeatures()
    return walkShadowPart(false, originWorld, direction, tMax, exactDistance, t);
#else
    // A loop, so that compilers inline the walk once. On an H100 sky rays take 0.78 of the time, local lights 1.23.
    bool stopped = false;
    t = tMax;
    int part = loopBegin(), end = frame.shadowPagedSize.w != 0 ? 2 : 1;
    do {
        stopped = walkShadowPart(part != 0, originWorld, direction, t, exactDistance, t) || stopped;
    } while (++part < end);
    return stopped;
#endif
}

/// The exact walk over the whole length.
bool shadowTrace(vec3 originWorld, vec3 direction, float tMax, out float t) {
    return shadowTraceCoarse(originWorld, direction, tMax, kAlwaysExact, t);
}

/// Whether the cell at a position (metres, from the render origin) is occupied in a part of the directory.
bool isOccupiedIn(bool isPaged, vec3 positionWorld) {
    ShadowPart part = shadowPart(isPaged);
    vec3 place = positionWorld * kShadowCellsPerMetre - vec3(part.first * 64);
    bool inside = all(greaterThanEqual(place, part.low)) && all(lessThan(place, part.high));
    ivec3 cell = ivec3(inside ? place : vec3(0.0)), at = isPaged ? cell >> 6 : cell >> 4;
    ivec3 size = isPaged ? part.sectors : part.sectors * 4;
    int index = at.x + size.x * (at.y + size.y * at.z);
    uint page = isPaged ? fetchShadowTable(index) : 0u;
    bool emptySector = (page & 15u) != 0u;
    int inPage = (cell.x >> 4 & 3) | (cell.y >> 2 & 12) | (cell.z & 48);
    uvec4 brick = fetchShadowBrick(!isPaged ? index : emptySector ? 0 : int(page) + inPage);
    int word = (cell.x >> 2 & 3) | (cell.y & 12) | (cell.z & 12) << 2;
    bool emptyWord = !inside || emptySector || (brick.x & 15u) != 0u ||
                     ((word < 32 ? brick.y : brick.z) >> uint(word & 31) & 1u) == 0u;
    uvec2 cells = fetchShadowTexel(emptyWord ? 0 : int(brick.x) + word);
    int inWord = (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4;
    return !emptyWord && ((inWord < 32 ? cells.x : cells.y) >> uint(inWord & 31) & 1u) != 0u;
}

/// Whether the cell at a position is occupied.
bool isShadowOccupied(vec3 positionWorld) {
    bool occupied = isOccupiedIn(false, positionWorld);
#ifndef NO_PAGED_SHADOWS
    if (frame.shadowPagedSize.w != 0 && !occupied) occupied = isOccupiedIn(true, positionWorld);
#endif
    return occupied;
}

/// A position moved along a normal out of the cells of its own surface, if these stick out by at most a share of their
/// size. A face that is aligned with the grid ends at a cell boundary, and the position comes to lie exactly there. The
/// cells of a rotated face stick out of it by at most that share of a cell's extent along the normal n, which is
/// |n.x| + |n.y| + |n.z| cells. A ray that starts a little beyond that and does not go down misses them, however the
/// body is rotated.
const float kNormalMarginCells = 0.02;
vec3 movedOffCells(vec3 positionWorld, vec3 normalWorld, float share) {
    vec3 along = abs(normalWorld);
    float cells = (share + kNormalMarginCells) * dot(along, vec3(1.0));
    if (max(along.x, max(along.y, along.z)) > 0.9999) {
        float height = dot(positionWorld, normalWorld) / kShadowCell;
        cells = ceil(height + share - 0.999) + 0.01 - height;
    }
    return positionWorld + normalWorld * (cells * kShadowCell);
}

/// Where a ray starts that leaves a face of a shadow cell, as other rays find it.
vec3 cellOrigin(vec3 positionWorld, vec3 normalWorld) { return movedOffCells(positionWorld, normalWorld, 0.5); }

/// A position moved out of occupied cells toward the side from which it is seen. The cells that it crosses stick out
/// of surfaces beside it: between it and the eye is nothing. The direction is bent away from the axes along which it
/// hardly moves, so that it is out of all layers of cells after about one. Deep between cells it stays in one: dark.
const int kMaxCellsLeft = 4;
vec3 movedTowardEye(vec3 positionWorld, vec3 toEyeWorld) {
    vec3 direction = toEyeWorld / (abs(toEyeWorld) + 0.1);
    vec3 inverse = 1.0 / max(abs(direction), 1e-4);
    bool isInside;
    int i = loopBegin();
    do {
        isInside = isShadowOccupied(positionWorld);
        vec3 inCell = fract(positionWorld * kShadowCellsPerMetre);
        vec3 leave = mix(1.0 - inCell, inCell, lessThan(direction, vec3(0.0))) * inverse;
        if (isInside) positionWorld += direction * ((min(leave.x, min(leave.y, leave.z)) + 0.01) * kShadowCell);
    } while (isInside && ++i < kMaxCellsLeft);
    return positionWorld;
}

/// Where a ray starts that leaves a surface which the camera sees: outside of the cells of the surface itself, and of
/// those beside it. Voxels at least as large as cells set the cells whose centres lie in them: half a cell sticks out
/// at most. Smaller ones, `fine` ones, set each cell that they touch: nearly all of it may stick out, also from
/// surfaces that meet this one at an edge (runtime/shadow/shadow_cell_transform.h).
vec3 surfaceOrigin(vec3 positionWorld, vec3 normalWorld, bool fine) {
    vec3 origin = movedOffCells(positionWorld, normalWorld, fine ? 0.98 : 0.5);
    return movedTowardEye(origin, toEye(positionWorld));
}
