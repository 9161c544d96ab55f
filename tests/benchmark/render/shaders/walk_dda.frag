// The plain 3D DDA, voxel by voxel with accumulated differences (Amanatides and Woo 1987), over a 3D texture.
#include "../tests/benchmark/render/shaders/one_ray.glsl"
#include "../tests/benchmark/render/shaders/dense_grid.glsl"

vec4 firstVoxel(vec3 origin, vec3 given) {
    vec3 direction, inverse;
    float tEnter, tLeave;
    if (!enterGrid(origin, given, direction, inverse, tEnter, tLeave)) return vec4(-1.0);
    ivec3 cell = clamp(ivec3(floor(origin + direction * (tEnter + kNudge))), ivec3(0), uSize - 1);
    ivec3 stepSign = ivec3(sign(direction));
    vec3 delta = abs(inverse);
    vec3 next = (vec3(cell) + step(0.0, direction) - origin) * inverse;
    float t = tEnter;
    for (int i = 0; i < 4096; ++i) {
        if (texelFetch(uVoxels, cell, 0).r > 0.0) return vec4(cell, max(t, 0.0));
        t = min(next.x, min(next.y, next.z));
        vec3 crossed = vec3(lessThanEqual(next, vec3(t)));
        if (crossed.x > 0.0)
            crossed.yz = vec2(0.0);
        else if (crossed.y > 0.0)
            crossed.z = 0.0;
        next += crossed * delta;
        cell += ivec3(crossed) * stepSign;
        if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, uSize))) break;
    }
    return vec4(-1.0);
}
