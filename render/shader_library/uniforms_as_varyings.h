#pragma once
#include <limits>

#include "render/shader_library/shader_source.h"

namespace rubble {

/// Makes a fragment program read its uniforms, and the members of `frame`, as flat inputs that its vertex program
/// writes. The values are the same. llvmpipe reads a component of a uniform by eight loads, about thirty instructions
/// for eight pixels, but a flat input by one. This is for programs of a few large triangles on software renderers; on a
/// GPU uniforms are cheaper. Arrays and bools stay uniforms, and what is read after `vectors` vectors of four numbers
/// are passed. Lines keep their numbers, for ShaderSource::explain().
void passUniformsAsVaryings(ShaderSource& vertex, ShaderSource& fragment,
                            int vectors = std::numeric_limits<int>::max());

/// How many vectors the vertex program of a full-screen shader may hand on beside its own few. [render-thread]
int varyingVectors();

}  // namespace rubble
