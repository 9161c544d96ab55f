#pragma once
#include "render/gl/gl.h"

namespace rubble {

/// Loads the functions of OpenGL ES 3.0, of which WebGL 2 is the browsers' form. What the renderer calls of desktop GL
/// beside them is given a meaning here, so that nothing else tells the two apart but for what ES cannot do at all:
/// - functions for the first of several targets become those for all, which have the same effect in our passes;
/// - state that ES lacks is neither set nor asked for: it is as in a new desktop context.
/// An error says what is missing. As all functions are the process's, its contexts must be of one kind at a time.
Result<Done> loadEmbeddedGl(GLADloadfunc find);

}  // namespace rubble
