#include "../tests/benchmark/world_rays/shaders/volume_3d.glsl"
#include "../tests/benchmark/world_rays/shaders/super_sparse.glsl"
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
