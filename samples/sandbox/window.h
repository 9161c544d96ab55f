#pragma once
#include "samples/sandbox/options.h"

namespace rubble {

/// Runs the game in a window until the player leaves. Returns the exit code.
int runWindow(const SandboxOptions& options);

}  // namespace rubble
