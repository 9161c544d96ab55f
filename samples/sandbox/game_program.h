#pragma once
#include "samples/sandbox/options.h"

namespace rubble {

/// Becomes the program rubble-game, which plays the town, or the level of the options, in a window or by a bot. Returns
/// an exit code where it cannot.
int playGame(const SandboxOptions& options);

/// Becomes the same program, which makes the film of the sandbox in the folder of the options.
int playFilm(const SandboxOptions& options);

}  // namespace rubble
