// The reference game's walk: a level finer where a cell holds something, a level coarser where an empty cell's parent is left.
#include "../tests/benchmark/render/shaders/one_ray.glsl"
#include "../tests/benchmark/render/shaders/dense_grid.glsl"

vec4 firstVoxel(vec3 origin, vec3 given) {
    vec3 direction, inverse;
    float tEnter, tLeave;
    if (!enterGrid(origin, given, direction, inverse, tEnter, tLeave)) return vec4(-1.0);
    vec3 ahead = step(0.0, direction);
    float t = tEnter;
    int level = 2;
    ivec3 voxel = clamp(ivec3(floor(origin + direction * (t + kNudge))), ivec3(0), uSize - 1);
    for (int i = 0; i < 4096; ++i) {
        ivec3 cell = voxel >> level;
        if (texelFetch(uVoxels, cell, level).r > 0.0) {
            if (level == 0) return vec4(voxel, t);
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
