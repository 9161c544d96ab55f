// Exact rays through the world's shadow volume (filled by render/scene/gpu_shadow_volume.cpp): bricks of 16^3 cells of 0.1 m, words of
// 4^3. One step leaps an empty cube of bricks, an empty box of words, what is left of a word that holds nothing ahead of the ray, 2^3 empty
// cells or a cell. Needs lib/frame.glsl first.

#include "shared/constants.h"

uniform usamplerBuffer uShadowDirectory;  // a texel a brick. Empty: x eight cubes (SkipDistances). Else: x 16 x slot, yz which words hold anything
uniform usamplerBuffer uShadowTexels;     // 64 texels a slot (ShadowBrick): the cells of a word, or its empty boxes

const float kShadowCellsPerMetre = 10.0;

// All fetches go through current: WebGL2 has no buffer textures and will read 2D ones.
uvec4 fetchShadowDirectory(int i) { return texelFetch(uShadowDirectory, i); }
uvec2 fetchShadowTexel(int i) { return texelFetch(uShadowTexels, i).rg; }

// A point of the world (from the render origin) in the directory's cells.
vec3 shadowCells(vec3 positionWorld) { return positionWorld * kShadowCellsPerMetre - vec3(frame.shadowSectorLow.xyz * 64); }

const float kAlwaysExact = 1.0e30;

// True if the ray from originWorld (metres, from the render origin) meets an occupied cell within tMax metres along the unit
// vector `direction`; t is where. An origin in an occupied cell is a hit at 0: see shadowOrigin().
// Beyond exactDistance metres a word of 4^3 cells that holds anything stops it: no light where there is none, some shadow too much.
bool shadowTraceCoarse(vec3 originWorld, vec3 direction, float tMax, float exactDistance, out float t) {
    t = tMax;
    bool coarse = exactDistance < kAlwaysExact;  // known when the shader is built
    exactDistance *= kShadowCellsPerMetre;
    ivec3 bricks = frame.shadowSectorCount.xyz * 4;
    // All axes are turned so that the ray goes up: cell c of a turned axis is cell (size - 1 - c) of the volume.
    bvec3 isDown = lessThan(direction, vec3(0.0));
    ivec3 down = ivec3(isDown);
    vec3 size = vec3(bricks * 16);
    vec3 along = max(abs(direction), vec3(1.0e-20));
    vec3 origin = shadowCells(originWorld);
    origin = mix(origin, size - origin, isDown);
    vec3 inverse = 1.0 / along;
    vec3 low = mix(frame.shadowLow.xyz, size - frame.shadowHigh.xyz, isDown);
    vec3 high = mix(frame.shadowHigh.xyz, size - frame.shadowLow.xyz, isDown);
    vec3 enter = (low - origin) * inverse, leave = (high - origin) * inverse;
    float current = max(max(enter.x, enter.y), max(enter.z, 0.0));
    float end = tMax * kShadowCellsPerMetre;
    end = leave.x < end ? leave.x : end;
    end = leave.y < end ? leave.y : end;
    end = leave.z < end ? leave.z : end;
    if (!(current < end)) return false;  // a NaN too
    ivec3 cell = clamp(ivec3(origin + along * current), ivec3(low), ivec3(high) - 1);

    ivec3 pitch = ivec3(1, bricks.x, bricks.x * bricks.y);
    ivec3 farthest = pitch * (bricks - 1);
    int first = (isDown.x ? farthest.x : 0) + (isDown.y ? farthest.y : 0) + (isDown.z ? farthest.z : 0);
    pitch = ivec3(isDown.x ? -pitch.x : pitch.x, isDown.y ? -pitch.y : pitch.y, isDown.z ? -pitch.z : pitch.z);
    int turned = 3 * (down.x + 4 * down.y + 16 * down.z);  // turns the number of a word in its brick, and of a cell in its word
    int octant = down.x + 2 * down.y + 4 * down.z;
    uint cubeShift = uint(octant * 4), boxShift = uint(octant * 2);
    // Which columns, rows and slices of a word a ray can still reach from each of the four: all ahead of it.
    uint columnsAhead = isDown.x ? 0x137fu : 0x8cefu, slicesAhead = isDown.z ? 0xffffu : 0xffff0000u;
    int rowsTurned = down.y - 1, rowsFirst = 13 - down.y;
    bool stopped = false;
    do {
        t = current;
        ivec3 brick = cell >> 4;
        uvec4 entry = fetchShadowDirectory(first + brick.x * pitch.x + brick.y * pitch.y + brick.z * pitch.z);
        bool emptyBrick = (entry.x & 15u) != 0u;
        int word = ((cell.x >> 2 & 3) | (cell.y & 12) | (cell.z & 12) << 2) ^ turned;
        bool emptyWord = ((word < 32 ? entry.y : entry.z) >> uint(word & 31) & 1u) == 0u;
        uvec2 texel = fetchShadowTexel(emptyBrick ? 0 : int(entry.x >> 4) * 64 + word);
        int inWord = ((cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4) ^ turned;
        uint nearHalf = inWord < 32 ? texel.x : texel.y, farHalf = inWord < 32 ? texel.y : texel.x;  // the two halves of the word
        stopped = !emptyWord && ((nearHalf >> uint(inWord & 31) & 1u) != 0u || (coarse && current > exactDistance));
        uint columns = (columnsAhead >> uint((cell.x & 3) << 2) & 15u) * 0x11111111u;
        uint rows = (0x0ffff000u >> uint(rowsFirst + ((cell.y & 3) << 2 ^ rowsTurned)) & 0xffffu) * 0x10001u;
        uint slices = (nearHalf & ((cell.z & 1) == 0 ? 0xffffffffu : slicesAhead)) | ((cell.z & 2) == 0 ? farHalf : 0u);
        bool nothingAhead = emptyWord || (slices & rows & columns) == 0u;
        bool emptyEight = (nearHalf >> uint(inWord & 10) & 0x00330033u) == 0u;  // the 2x2x2 cells that hold this one
        ivec3 box = ivec3(uvec3(texel.x >> boxShift, texel.x >> (boxShift + 16u), texel.y >> boxShift) & 3u) + 1;
        ivec3 leap = emptyBrick ? ivec3(entry.x >> cubeShift & 15u) : emptyWord ? box : ivec3(1);
        int unit = emptyBrick ? 4 : nothingAhead ? 2 : emptyEight ? 1 : 0;
        ivec3 plane = ((cell >> unit) + leap) << unit;
        leave = (vec3(plane) - origin) * inverse;
        float next = leave.y < leave.z ? leave.y : leave.z;
        next = leave.x < next ? leave.x : next;
        ivec3 beside = clamp(ivec3(origin + along * next), cell, plane - 1);  // never back: a point is rounded
        // Round corners, never through them.
        bool acrossX = leave.x <= next, acrossY = !acrossX && leave.y <= next;
        cell = ivec3(acrossX ? plane.x : beside.x, acrossY ? plane.y : beside.y, acrossX || acrossY ? beside.z : plane.z);
        current = next;
    } while (!stopped && current < end);
    t = stopped ? t * kShadowCell : tMax;
    return stopped;
}

/// The exact one.
bool shadowTrace(vec3 originWorld, vec3 direction, float tMax, out float t) { return shadowTraceCoarse(originWorld, direction, tMax, kAlwaysExact, t); }

// THE rule for leaving one's own surface. A body sets the cells whose centres lie in it. A face along the grid therefore ends in
// the cells at the boundary nearest to it: the ray starts there, exactly. The cells of a turned body reach up to half a cell's
// extent along the normal out of its faces, vec3(1) dot |normal| being 1 to 1.73 cells: from there (and a hair) a ray that does
// not go down never meets them, however the body is turned.
const float kNormalOffsetCells = 0.52;
vec3 shadowOrigin(vec3 positionWorld, vec3 normalWorld) {
    vec3 along = abs(normalWorld);
    float cells = kNormalOffsetCells * dot(along, vec3(1.0));
    if (max(along.x, max(along.y, along.z)) > 0.9999) {
        float height = dot(positionWorld, normalWorld) / kShadowCell;
        cells = ceil(height - 0.499) + 0.01 - height;
    }
    return positionWorld + normalWorld * (cells * kShadowCell);
}
