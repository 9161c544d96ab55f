// Steps a ray through cells, in blocks of any power of two. Every crossing's t is computed from its integer plane, so
// nothing accumulates (Amanatides & Woo 1987, with that error removed). The C++ side is runtime/voxel/cell_walk.h.
// A point on a face belongs to the cell that the ray is going into; to the higher one if it runs along the face.
const float kNever = 3.0e38;     // later than any crossing
const float kFarthest = 1.0e30;  // no ray goes on longer
// Directions have a length near 1 (1e-6 to 1e6): a component below this moves nothing that a float could tell.
const float kZeroDirection = 1.0e-20;

struct CellWalk {
    vec3 origin, direction;
    vec3 inverse;   // 1 / direction, 0 where that is zero
    vec3 never;     // kNever where the direction is zero, else 0
    ivec3 ahead;    // 1 where the ray goes up or nowhere, 0 where it goes down
    ivec3 cell;
    float t;
    ivec3 axis;     // 1 on the axis of the face that the cell was entered through; 0 if the ray began in it
};

// Puts a ray into the box [low, high), at tMin or where it enters. False if it misses, or holds a NaN or an infinity
// (tMax may be infinite).
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
    w.axis = enter.x >= first ? ivec3(1, 0, 0) : enter.y >= first ? ivec3(0, 1, 0) : ivec3(0, 0, enter.z >= first ? 1 : 0);
    vec3 point = origin + direction * first;
    ivec3 begin = clamp(ivec3(mix(ceil(point) - 1.0, floor(point), up)), low, high - 1);
    w.cell = w.axis * (low + (1 - w.ahead) * (high - 1 - low)) + (1 - w.axis) * begin;

    bvec3 outside = bvec3(ivec3(lessThan(origin, vec3(low))) + ivec3(greaterThanEqual(origin, vec3(high))));
    bool beside = any(bvec3(ivec3(zero) * ivec3(outside)));
    // isnan, as compilers turn comparisons round and a NaN then passes.
    bool finite = !any(isnan(origin)) && !any(isnan(direction)) && !isnan(tMax) && all(lessThan(abs(origin), vec3(kFarthest))) &&
                  all(lessThan(abs(direction), vec3(kFarthest)));
    return finite && tMax >= tMin && !beside && first <= min(min(leave.x, leave.y), min(leave.z, tMax));
}

// To the first cell outside the block of `size` cells (a power of two, aligned) that holds the present one.
void leaveBlock(inout CellWalk w, int size) {
    ivec3 low = w.cell & ivec3(-size);
    vec3 leave = (vec3(low + w.ahead * size) - w.origin) * w.inverse + w.never;
    w.t = min(leave.x, min(leave.y, leave.z));
    w.axis = leave.x <= w.t ? ivec3(1, 0, 0) : leave.y <= w.t ? ivec3(0, 1, 0) : ivec3(0, 0, 1);
    ivec3 beside = clamp(ivec3(floor(w.origin + w.direction * w.t)), low, low + (size - 1));
    // Never back: rounding may put a point a hair before the cell that the ray is in.
    beside = w.ahead * max(beside, w.cell) + (1 - w.ahead) * min(beside, w.cell);
    ivec3 across = low - 1 + w.ahead * (size + 1);
    w.cell = w.axis * across + (1 - w.axis) * beside;
}

bool insideCells(ivec3 cell, ivec3 low, ivec3 high) { return all(greaterThanEqual(cell, low)) && all(lessThan(cell, high)); }

// Of 4x4x4 children, a 64-bit mask (bit x + 4 y + 16 z) says which are there. For the child at c (its lowest two bits count):
// 0 if it is there, 2 if none of its aligned 2x2x2 is, else 1: the side of an empty block, in children.
int emptyChildren(uvec2 mask, ivec3 c) {
    uint layer = (c.z & 2) == 0 ? mask.x : mask.y;
    uint octant = layer >> uint((c.x & 2) + (c.y & 2) * 4);
    if ((octant & 0x00330033u) == 0u) return 2;
    return 1 - int(octant >> uint((c.x & 1) + (c.y & 1) * 4 + (c.z & 1) * 16) & 1u);
}
// The place of a child among 4x4x4.
int childOf(ivec3 c) { return (c.x & 3) + (c.y & 3) * 4 + (c.z & 3) * 16; }
