#pragma once
#include <string>

#include "samples/stress/run.h"

namespace stress {

/// FOLDER/NAME_SEED with an ending: the files of a run.
std::string resultPath(const RunSettings& settings, const std::string& ending);

/// Removes what an earlier run of the name and seed has left, and writes NAME_SEED.json.part, which becomes
/// NAME_SEED.json with the figures: so a run that ends without them is known. An error, or "": those of another
/// scenario's file of the same name stay.
std::string beginResults(const RunSettings& settings, const std::string& build);

/// A word of a command line, in quotes where a shell needs them.
std::string shellWord(const std::string& text);

}  // namespace stress
