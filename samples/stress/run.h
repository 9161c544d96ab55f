#pragma once
#include <rubble/rubble.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/script/binding/script_context.h"

namespace stress {

/// A scenario to play.
struct RunSettings {
    std::string name, script;  ///< the name of a Lua text, and the text
    std::string file;          ///< of the text; "": one of the scenarios of the program
    uint64_t seed = 1;
    int steps = 1200;
    int checkInterval = 240;  ///< steps between the checks that take long; a recording has two such intervals at most
    int replayEvery = 1;      ///< the first of so many recordings is played again, with two threads; 0: none
    std::string levels;       ///< the folder of levels that scripts may load
    std::string folder;       ///< for recordings
    int images = 0;           ///< how many games are kept at most, to be drawn
    bool hasThreads = false;  ///< the shadow worker on its own thread, and two threads for physics
    rubble::script::CallObserver* observer = nullptr;
    bool isQuiet = false;  ///< what scripts print and the world logs is not shown
    std::function<void(int step)> onStep;
    std::function<void(const std::string& message)> onFailure;  ///< at once, within the call that has failed
    std::function<bool()> isInterrupted;                        ///< whether the run shall end before its steps are done
    std::function<uint64_t()> heldBytes;                        ///< of the heap: what the caller keeps of the run
};

/// What did not hold.
struct Failure {
    std::string check, message;
    int step = 0;
};

/// Measures of one step.
struct StepFigures {
    float editsMs, physicsMs, posesMs, impactsMs, shadowMs;  ///< wall clock
    uint32_t bodies, awake, contacts, shadowLag;
    uint64_t standing, pieces, removed;  ///< voxels
    double energy;                       ///< kinetic, joules
    uint64_t heap;                       ///< bytes in use, without what the program keeps of the run
};

/// What came of a run.
struct RunResult {
    std::optional<Failure> failure;
    bool isInterrupted = false;  ///< it ended early, see RunSettings
    std::vector<StepFigures> steps;
    std::vector<std::vector<uint8_t>> games;  ///< saved games to be drawn
    uint64_t hash = 0;                        ///< after the last step
    std::map<std::string, double> seconds;    ///< of processor time of all threads, by what was done
    int64_t heapLeft = 0;                     ///< bytes in use that were not in use before the run
    int replayed = 0;                         ///< steps that gave the same hash when played from a recording
    int loads = 0;                            ///< of levels and games
};

/// Plays a scenario in a world of its own with all checks, until its steps are done or something does not hold.
RunResult play(const rubble_api& api, const RunSettings& settings);

/// Bytes of the heap in use.
uint64_t heapBytes();
/// Bytes of the heap in a block, with what malloc needs for it.
uint64_t blockBytes(const void* block);
/// What a result holds itself.
uint64_t bytesOf(const RunResult& result);

}  // namespace stress
