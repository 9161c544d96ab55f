uniform usampler3D uVolume;
uint fetchLevel(ivec3 texel, int level) { return texelFetch(uVolume, texel, level).r; }
#include "../tests/benchmark/world_rays/shaders/teardown_walk.glsl"
