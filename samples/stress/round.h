#pragma once
#include <functional>
#include <string>
#include <vector>

#include "samples/stress/mechanical_energy.h"

namespace rubble {

/// A level, loaded and demolished for some steps: all that happens follows from the numbers here.
struct Round {
    uint64_t seed = 1;
    int number = 0;
    int steps = 3600, editsEvery = 10;
    int threads = 1;               ///< of physics
    int recordedSteps = 120;       ///< half-way: a save, and these steps recorded, to be loaded and replayed; 0: none
    const Level* level = nullptr;  ///< null: the stress level
};

/// What came of a round.
struct RoundResult {
    std::string wrong;             ///< "": all that must hold did
    std::vector<uint64_t> hashes;  ///< every 60 steps
    std::vector<double> stepMs;
    size_t mostBodies = 0, edits = 0, pieces = 0, removed = 0;
    MechanicalEnergy energy;
    size_t liveBytes = 0, residentBytes = 0;  ///< of the process, when everything is gone again
};

/// `advanced` is told after each step.
RoundResult playRound(const Round& round, const std::function<void()>& advanced);

}  // namespace rubble
