// Teardown's walk: a level finer where a cell is occupied, a level coarser where the ray leaves an empty cell's parent.
// Returns cell and t, -1 for a miss.
vec4 firstVoxel(vec3 origin, vec3 given, float tMax, out vec3 normal) {
    vec3 direction, inverse;
    float tEnter, tLeave;
    normal = vec3(0.0);
    if (!enterGrid(origin, given, direction, inverse, tEnter, tLeave)) return vec4(-1.0);
    vec3 ahead = step(0.0, direction);
    tLeave = min(tLeave, tMax);
    float t = tEnter;
    int level = 2;
    ivec3 voxel = clamp(ivec3(floor(origin + direction * (t + kNudge))), ivec3(0), uSize - 1);
    if (t > tLeave) return vec4(-1.0);
    for (int i = 0; i < 4096; ++i) {
        ivec3 cell = voxel >> level;
        if (texelFetch(uVoxels, cell, level).r > 0.0) {
            if (level == 0) {
                vec3 enter = (vec3(voxel) + 1.0 - ahead - origin) * inverse;
                float last = max(enter.x, max(enter.y, enter.z));
                normal = -sign(direction) * vec3(enter.x >= last, enter.y >= last && enter.x < last,
                                                 enter.z >= last && max(enter.x, enter.y) < last);
                return vec4(voxel, t);
            }
            --level;
            continue;
        }
        vec3 leave = (vec3(cell) + ahead) * float(1 << level);
        leave = (leave - origin) * inverse;
        t = min(leave.x, min(leave.y, leave.z));
        if (t + kNudge >= tLeave) break;
        voxel = clamp(ivec3(floor(origin + direction * (t + kNudge))), ivec3(0), uSize - 1);
        if (level < 2 && (voxel >> (level + 1)) != (cell >> 1)) ++level;
    }
    return vec4(-1.0);
}
