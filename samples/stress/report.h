#pragma once
#include <string>

#include "samples/stress/minimise.h"

namespace stress {

/// Writes NAME_SEED.json into the folder of the run: the build and the machine, figures of each stage, plots of at most
/// 600 points, what failed, the short script of it, and the command that plays the run again. An error, or "".
std::string writeFigures(const std::string& build, const std::string& command, const RunSettings& settings,
                         const RunResult& result, double seconds, const Minimised& found);

/// Draws kept games, from above their middle, as NAME_SEED_1.png and so on into the folder of the run. An error, or "":
/// without OpenGL there is one.
std::string drawGames(const rubble_api& api, const RunSettings& settings, const RunResult& result);

}  // namespace stress
