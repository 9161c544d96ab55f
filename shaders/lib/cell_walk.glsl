// Steps a ray through cells, in blocks of any power of two. Every crossing's t is computed from its integer plane, so
// nothing accumulates (Amanatides & Woo 1987, with that error removed). The C++ side is runtime/voxel/cell_walk.h.
// A point on a face belongs to the cell that the ray is going into; to the higher one if it runs along the face.
const float kNever = 3.0e38;
// Below this share of the direction's length a component moves nothing that a float could tell, and its inverse may overflow.
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

// Puts a ray into the box [low, high), at tMin or where it enters. False if it misses, or holds a NaN.
bool startWalk(out CellWalk w, vec3 origin, vec3 direction, float tMin, float tMax, ivec3 low, ivec3 high) {
    bvec3 zero = lessThan(abs(direction), vec3(kZeroDirection));
    w.origin = origin;
    w.direction = direction;
    w.inverse = mix(1.0 / mix(direction, vec3(1.0), zero), vec3(0.0), zero);
    w.never = mix(vec3(0.0), vec3(kNever), zero);
    bvec3 up = greaterThanEqual(direction, vec3(0.0));
    w.ahead = ivec3(up);
    vec3 near = mix(vec3(high), vec3(low), up), far = mix(vec3(low), vec3(high), up);
    vec3 enter = (near - origin) * w.inverse - w.never;
    vec3 leave = (far - origin) * w.inverse + w.never;
    float first = max(max(enter.x, enter.y), max(enter.z, tMin));
    w.t = first;
    w.axis = enter.z >= first ? ivec3(0, 0, 1) : enter.y >= first ? ivec3(0, 1, 0) : ivec3(enter.x >= first ? 1 : 0, 0, 0);
    w.cell = clamp(ivec3(floor(origin + direction * first)), low, high - 1);
    w.cell = w.axis * (low + (1 - w.ahead) * (high - 1 - low)) + (1 - w.axis) * w.cell;
    bool beside = any(lessThan(mix(vec3(0.0), origin - vec3(low), zero), vec3(0.0))) ||
                  any(greaterThanEqual(mix(vec3(-1.0), origin - vec3(high), zero), vec3(0.0)));
    // Written so that a NaN makes it false.
    return !beside && first <= min(min(leave.x, leave.y), min(leave.z, tMax)) && any(not(zero)) == true && direction == direction;
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

// Bit i of a 64-bit mask.
bool bitOf(uvec2 mask, int i) { return (((i < 32 ? mask.x : mask.y) >> uint(i & 31)) & 1u) != 0u; }
// The place of a child among 4x4x4.
int childOf(ivec3 c) { return (c.x & 3) + (c.y & 3) * 4 + (c.z & 3) * 16; }
