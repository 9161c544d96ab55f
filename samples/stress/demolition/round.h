#pragma once
#include <functional>
#include <string>
#include <vector>

#include "runtime/plugin/frame_loop.h"

namespace rubble {

/// A demolition of a level for some steps. It is fully determined by these members.
struct Round {
    uint64_t seed = 1;
    int number = 0;
    int steps = 3600, editInterval = 10;
    int recordedSteps = 120;       ///< recorded half-way and replayed; 0: none
    const Level* level = nullptr;  ///< null: the stress level
};

/// Result of a round.
struct RoundResult {
    std::string error;                                                ///< "": all invariants held
    std::vector<uint64_t> hashes;                                     ///< every 60 steps
    double meanMs = 0.0, medianMs = 0.0, p99Ms = 0.0, worstMs = 0.0;  ///< processor time of a step
    size_t maxBodies = 0, edits = 0, pieces = 0, removed = 0;
    int comparedSteps = 0;            ///< steps whose energy could be compared
    double lost = 0.0, gained = 0.0;  ///< joules, in the compared steps
    size_t maxHeapBytes = 0;          ///< largest size of the heap in use
};

/// Settings of a frame loop without renderer; `threads`: for physics.
FrameLoopSettings stressLoop(int threads);
/// Loads the round's level into a loop; what was in the loop is removed.
void loadRound(const Round& round, FrameLoop& loop);
/// Plays a round in a loop that has just loaded the round's level or a save of it. Calls `onStep` after each step.
RoundResult playRound(const Round& round, FrameLoop& loop, const std::function<void()>& onStep);

/// Bytes of the heap in use.
size_t heapBytes();
/// Loads an empty level into a loop and returns the bytes of the heap that remain in use.
size_t heapBytesWhenEmptied(FrameLoop& loop);
/// Bytes of the process that are in physical memory.
size_t residentBytes();

}  // namespace rubble
