// One object as Teardown stores it: a 3D texture of a byte a voxel, with two coarser levels.
uniform sampler3D uVoxels;
uniform ivec3 uSize;
const float kNudge = 1e-4;
const float kNever = 1e30;

/// False if the ray misses the box. `direction` is `given` without zeros.
bool enterGrid(vec3 origin, vec3 given, out vec3 direction, out vec3 inverse, out float tEnter, out float tLeave) {
    direction = mix(given, vec3(1e-7), lessThan(abs(given), vec3(1e-7)));
    inverse = 1.0 / direction;
    vec3 a = -origin * inverse, b = (vec3(uSize) - origin) * inverse;
    vec3 near = min(a, b), far = max(a, b);
    tEnter = max(max(near.x, near.y), max(near.z, 0.0));
    tLeave = min(far.x, min(far.y, far.z));
    return tEnter <= tLeave;
}
