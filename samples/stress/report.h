#pragma once
#include <string>

#include "samples/stress/run.h"

namespace stress {

/// Writes NAME_SEED.json into a folder: the build and the machine, figures of each stage, plots of at most 600 points,
/// what failed. `script`: the minimised one, or "". An error, or "".
std::string writeFigures(const std::string& folder, const std::string& build, const RunSettings& settings,
                         const RunResult& result, double seconds, const std::string& script);

/// Draws kept games, from above their middle, as NAME_SEED_1.png and so on into a folder. An error, or "": without
/// OpenGL there is one.
std::string drawGames(const rubble_api& api, const std::string& folder, const RunSettings& settings,
                      const RunResult& result);

}  // namespace stress
