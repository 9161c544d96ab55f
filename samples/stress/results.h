#pragma once
#include <string>

#include "samples/stress/run.h"

namespace stress {

/// FOLDER/NAME_SEED with an ending: the files of a run.
std::string resultPath(const RunSettings& settings, const std::string& ending);

/// The files of a run: no other process writes them while this is there.
class ResultFiles {
public:
    ResultFiles() = default;
    ~ResultFiles();
    ResultFiles(const ResultFiles&) = delete;
    ResultFiles& operator=(const ResultFiles&) = delete;

    /// Removes what an earlier run of the name and seed has left, and writes NAME_SEED.json.part, which becomes
    /// NAME_SEED.json with the figures: so a run that ends without them is known. An error, or "": those of another
    /// scenario's file of the same name stay, as do those of a run that goes on.
    std::string begin(const RunSettings& settings, const std::string& build);

private:
    int m_begun = -1;  ///< NAME_SEED.json.part, locked, also after it was renamed
};

/// A word of a command line, in quotes where a shell needs them.
std::string shellWord(const std::string& text);

}  // namespace stress
