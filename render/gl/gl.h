#pragma once
#include <glad/gl.h>

#include <string_view>

#include "runtime/core/result.h"

namespace rubble {

/// Texture units that the renderer uses: the first one for uploads, the others for the samplers of programs.
inline constexpr int kTextureUnits = 32;

/// Loads the functions of GL 3.3 core, and of compute where there are some, or those of OpenGL ES 3.0, through a host's
/// loader. The context must be current. An error says what is missing.
Result<Done> loadGl(void* (*loader)(const char* name));
/// Whether the context is of OpenGL ES, as those of browsers (WebGL 2) are: see render/gl/embedded_gl.h.
bool isEmbedded();
/// Whether the context has an extension, by its name.
bool offers(std::string_view extension);
/// Whether the context is of GL 4.3 or newer: it has compute programs and images to store into.
bool hasCompute();
/// Whether the context is of a compatibility profile.
bool isCompatibility();
/// Sets how such a context changes pixels that are uploaded or copied, as glPixelTransferf().
void setPixelTransfer(GLenum name, GLfloat value);
inline constexpr GLuint kAnyCompilerThreads = ~GLuint(0);
/// Sets how many threads of its own the driver may compile programs with; kAnyCompilerThreads leaves it to the driver.
/// Returns the number before. Does nothing where the GL has no such setting (KHR_parallel_shader_compile).
GLuint setCompilerThreads(GLuint count);
/// Whether the renderer runs on the processor: timer queries do not see its work, and glFinish costs nothing.
bool isSoftwareGl();

/// Whether the context has been lost (a driver reset, a GPU taken away), where the GL can tell. All its objects are
/// gone.
bool isContextLost();

}  // namespace rubble
