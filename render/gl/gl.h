#pragma once
#include <glad/gl.h>

#include "runtime/core/result.h"

namespace rubble {

/// Texture units that the renderer uses: samplers of programs from the first on (mirrors take 23), the last one for
/// uploads.
inline constexpr int kTextureUnits = 32;

/// Loads the functions of GL 3.3 core through a host's loader. Fails with what is missing.
Result<Done> loadGl(void* (*loader)(const char* name));
/// True if the context is of GL 4.3 or newer: it has compute programs, and images to store into.
bool hasCompute();
/// True on a renderer without a GPU, where a timer query says little and glFinish costs nothing.
bool isSoftwareGl();

/// True once the context has been lost (a driver reset, a GPU taken away), where the GL can tell. Everything made in it
/// is gone.
bool isContextLost();

}  // namespace rubble
