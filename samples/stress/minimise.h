#pragma once
#include <string>
#include <vector>

#include "samples/stress/command_log.h"
#include "samples/stress/run.h"

namespace stress {

/// A short script that fails as a run did.
struct Minimised {
    std::string script;  ///< "" if the commands of the run alone do not fail the same way
    std::string why;     ///< where there is none
    int steps = 0;       ///< of a run of it
    Failure failure;
    int runs = 0;  ///< that it took
};

/// Leaves out commands of a failed run, as many as it can, so that it still fails the same way: by the same check, and
/// where a call was refused, by the same function and reason. That is delta debugging as in
/// Zeller and Hildebrandt, "Simplifying and Isolating Failure-Inducing Input" (2002), on commands with what they need.
/// Plays at most `maxRuns` times.
Minimised minimise(const rubble_api& api, const RunSettings& settings, const Failure& failure,
                   const std::vector<Command>& commands, int maxRuns);

}  // namespace stress
