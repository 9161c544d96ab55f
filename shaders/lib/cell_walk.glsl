// Steps a ray o + t d through a grid of cells, in blocks of any power of two (a 3D DDA: Amanatides and Woo 1987).
//
// The ray leaves the block [low, high) across the plane that comes first: per axis t = (plane - o) / d with plane =
// high where d > 0 and low where d < 0; the smallest t wins. Amanatides and Woo add a constant 1 / |d| at each
// crossing, and rounding errors add up. Here each t is computed from the integer number of its plane, so that errors do
// not accumulate. The new cell lies beyond that plane on the winning axis; on the others it is the cell of the point
// o + t d, clamped to the block and never behind the present cell, as rounding may put the point a little outside.
// A point on a face belongs to the cell that the ray goes into, or to the higher one if it runs along the face.
// The C++ side is runtime/voxel/cell_walk.h.
const float kNever = 3.0e38;     // later than any crossing
const float kFarthest = 1.0e30;  // longest ray
// Directions have a length of 1e-6 to 1e6: a component below this moves a point by less than a float can tell.
const float kZeroDirection = 1.0e-20;

struct CellWalk {
    vec3 origin, direction;
    vec3 inverse;  // 1 / direction, 0 where that is zero
    vec3 never;    // kNever where the direction is zero, else 0
    ivec3 ahead;   // 1 where the ray goes up or not at all, 0 where it goes down
    ivec3 cell;
    float t;
    ivec3 axis;  // 1 on the axis of the face that the cell was entered through; 0 if the ray began in it
};

/// Puts a ray into the box [low, high), at tMin or where it enters. False if it misses the box, or if a number is NaN
/// or infinite (tMax may be infinite).
bool startWalk(out CellWalk w, vec3 origin, vec3 direction, float tMin, float tMax, ivec3 low, ivec3 high) {
    bvec3 zero = lessThan(abs(direction), vec3(kZeroDirection));
    bvec3 up = greaterThanEqual(mix(direction, vec3(0.0), zero), vec3(0.0));
    w.origin = origin;
    w.direction = direction;
    w.inverse = mix(1.0 / mix(direction, vec3(1.0), zero), vec3(0.0), zero);
    w.never = mix(vec3(0.0), vec3(kNever), zero);
    w.ahead = ivec3(up);
    vec3 enter = (mix(vec3(high), vec3(low), up) - origin) * w.inverse - w.never;
    vec3 leave = (mix(vec3(low), vec3(high), up) - origin) * w.inverse + w.never;
    float first = max(max(enter.x, enter.y), max(enter.z, tMin));
    w.t = first;
    w.axis = enter.x >= first   ? ivec3(1, 0, 0)
             : enter.y >= first ? ivec3(0, 1, 0)
                                : ivec3(0, 0, enter.z >= first ? 1 : 0);
    vec3 point = origin + direction * first;
    ivec3 begin = clamp(ivec3(mix(ceil(point) - 1.0, floor(point), up)), low, high - 1);
    w.cell = w.axis * (low + (1 - w.ahead) * (high - 1 - low)) + (1 - w.axis) * begin;

    bvec3 outside = bvec3(ivec3(lessThan(origin, vec3(low))) + ivec3(greaterThanEqual(origin, vec3(high))));
    bool beside = any(bvec3(ivec3(zero) * ivec3(outside)));
    // isnan(), as compilers may turn a comparison around, and a NaN then passes.
    bool finite = !any(isnan(origin)) && !any(isnan(direction)) && !isnan(tMax) &&
                  all(lessThan(abs(origin), vec3(kFarthest))) && all(lessThan(abs(direction), vec3(kFarthest)));
    return finite && tMax >= tMin && !beside && first <= min(min(leave.x, leave.y), min(leave.z, tMax));
}

/// Moves to the first cell outside the present cell's block of `size` cells a side (a power of two, aligned).
void leaveBlock(inout CellWalk w, int size) {
    ivec3 low = w.cell & ivec3(-size);
    vec3 leave = (vec3(low + w.ahead * size) - w.origin) * w.inverse + w.never;
    w.t = min(leave.x, min(leave.y, leave.z));
    w.axis = leave.x <= w.t ? ivec3(1, 0, 0) : leave.y <= w.t ? ivec3(0, 1, 0) : ivec3(0, 0, 1);
    ivec3 beside = clamp(ivec3(floor(w.origin + w.direction * w.t)), low, low + (size - 1));
    // Never back: the rounded point may lie a little before the present cell.
    beside = w.ahead * max(beside, w.cell) + (1 - w.ahead) * min(beside, w.cell);
    ivec3 across = low - 1 + w.ahead * (size + 1);
    w.cell = w.axis * across + (1 - w.axis) * beside;
}

bool insideCells(ivec3 cell, ivec3 low, ivec3 high) {
    return all(greaterThanEqual(cell, low)) && all(lessThan(cell, high));
}

/// Side of the empty block that holds child c, in children: 0 if the child is occupied, 2 if its aligned 2x2x2 is
/// empty, else 1. mask: bit x + 4 y + 16 z is set for each occupied one of 4x4x4 children. Only the lowest two bits of
/// c count.
int emptyChildren(uvec2 mask, ivec3 c) {
    uint layer = (c.z & 2) == 0 ? mask.x : mask.y;
    uint octant = layer >> uint((c.x & 2) + (c.y & 2) * 4);
    if ((octant & 0x00330033u) == 0u) return 2;
    return 1 - int(octant >> uint((c.x & 1) + (c.y & 1) * 4 + (c.z & 1) * 16) & 1u);
}
/// Number of a child among 4x4x4.
int childOf(ivec3 c) { return (c.x & 3) + (c.y & 3) * 4 + (c.z & 3) * 16; }
