// What Teardown's walks share: 2x2x2 cells in a byte, at full, half and quarter resolution. Only the full resolution
// tests single cells; coarser levels test a whole byte, 4 and 8 cells wide, which is also their step.
uniform ivec3 uCells;

bool solidAt(vec3 point, int level) {
    ivec3 cell = ivec3(point);
    uint texel = fetchLevel(cell >> (level + 1), level);
    uint bit = level == 0 ? 1u << uint((cell.x & 1) + (cell.y & 1) * 2 + (cell.z & 1) * 4) : 255u;
    return (texel & bit) != 0u;
}
/// Distance at which the ray leaves the volume, in cells.
float leaveVolume(vec3 origin, vec3 direction, float tMax) {
    vec3 d = mix(direction, vec3(1e-20), equal(direction, vec3(0.0)));
    vec3 leave = (step(vec3(0.0), d) * vec3(uCells) - origin) / d;
    return min(tMax, min(leave.x, min(leave.y, leave.z)) - 1e-3);
}
