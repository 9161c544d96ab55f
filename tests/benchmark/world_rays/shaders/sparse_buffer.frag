#include "../tests/benchmark/world_rays/shaders/volume_buffer.glsl"
#include "../tests/benchmark/world_rays/shaders/sparse.glsl"
#include "../tests/benchmark/world_rays/shaders/trace.glsl"
