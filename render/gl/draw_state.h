#pragma once
#include <glm/vec2.hpp>

#include "render/gl/gl.h"

namespace rubble {

/// How a draw is combined with what its first target holds: factors and equations as glBlendFuncSeparate() and
/// glBlendEquationSeparate() take them.
struct Blend {
    GLenum source = GL_ONE, destination = GL_ZERO;
    GLenum sourceAlpha = GL_ONE, destinationAlpha = GL_ZERO;
    GLenum equation = GL_FUNC_ADD, equationAlpha = GL_FUNC_ADD;
};

// GL has a viewport and blending for each of several targets, and functions that set those of all. These set the first
// one alone, so that the host's others stay as they are.

/// Blending of the first target, which is on from then on.
void setBlend(const Blend& blend);
/// No blending of the first target.
void disableBlend();
/// The functions of setBlend(), without enabling anything.
void setBlendFunctions(const Blend& blend);
/// What setBlendFunctions() sets, as the GL has it. Asks the GL six times.
Blend currentBlend();
/// The viewport, from the corner (0, 0) on.
void setViewport(glm::ivec2 size);
/// The viewport, in pixels.
void setViewport(const GLfloat (&rectangle)[4]);
/// The depth range.
void setDepthRange(double nearest, double farthest);
/// Whether pixels outside the scissor rectangle are discarded.
void setScissorTest(bool on);
/// The scissor rectangle: its lower left corner and its size, in pixels.
void setScissor(glm::ivec2 low, glm::ivec2 size);

}  // namespace rubble
