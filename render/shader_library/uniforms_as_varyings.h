#pragma once
#include "render/shader_library/shader_source.h"

namespace rubble {

/// Lets a fragment program read its uniforms, and the members of `frame`, as flat inputs that its vertex program
/// writes: the same numbers. llvmpipe reads a component of a uniform by eight loads, some thirty instructions for eight
/// pixels, and one of a flat input by one. For programs of a few large triangles, on software renderers; on a GPU a
/// uniform is the cheaper one. Arrays and bools stay uniforms. Lines keep their places, for explain().
void passUniformsAsVaryings(ShaderSource& vertex, ShaderSource& fragment);

}  // namespace rubble
