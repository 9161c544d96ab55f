#pragma once
#include "samples/sandbox/options.h"

namespace rubble {

/// The game: a window, a camera and three tools. Exit code.
int runWindow(const SandboxOptions& options);

}  // namespace rubble
