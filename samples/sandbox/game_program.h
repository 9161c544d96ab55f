#pragma once
#include "samples/sandbox/options.h"

namespace rubble {

/// Becomes the program rubble-game, which plays the town, or the level of the options, in a window or by a bot. Returns
/// an exit code where it cannot.
int playGame(const SandboxOptions& options);

}  // namespace rubble
