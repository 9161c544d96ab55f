// Temporal accumulation of mirror rays (lib/reflection_history.glsl) where nothing is known to have changed.
#include "lib/reflection_history.glsl"

float framesLeft(Mirror m, vec3 seen, float lum) { return kMaxFrames; }
bool isImageChanged(Mirror m, float metres) { return false; }
