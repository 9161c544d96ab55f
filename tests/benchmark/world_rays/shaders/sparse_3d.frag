#include "../tests/benchmark/world_rays/shaders/volume_3d.glsl"
#include "../tests/benchmark/world_rays/shaders/sparse.glsl"
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
