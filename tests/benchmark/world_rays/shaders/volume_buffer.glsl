uniform usamplerBuffer uVolume;
uniform ivec4 uLevel0;  // xyz size in texels, w first texel
uniform ivec4 uLevel1;
uniform ivec4 uLevel2;
uint fetchLevel(ivec3 texel, int level) {
    ivec4 at = level == 0 ? uLevel0 : level == 1 ? uLevel1 : uLevel2;
    return texelFetch(uVolume, at.w + texel.x + at.x * (texel.y + at.y * texel.z)).r;
}
#include "../tests/benchmark/world_rays/shaders/teardown_walk.glsl"
