#pragma once
#include <functional>
#include <string>
#include <vector>

#include "runtime/plugin/frame_loop.h"

namespace rubble {

/// A level, demolished for some steps: all that happens follows from the numbers here.
struct Round {
    uint64_t seed = 1;
    int number = 0;
    int steps = 3600, editInterval = 10;
    int recordedSteps = 120;  ///< half-way: a save, and these steps recorded, to be loaded and replayError; 0: none
    const Level* level = nullptr;  ///< null: the stress level
};

/// What came of a round.
struct RoundResult {
    std::string error;                                                ///< "": all that must hold did
    std::vector<uint64_t> hashes;                                     ///< every 60 steps
    double meanMs = 0.0, medianMs = 0.0, p99Ms = 0.0, worstMs = 0.0;  ///< of processor time, a step
    size_t maxBodies = 0, edits = 0, pieces = 0, removed = 0;
    int comparedSteps = 0;            ///< steps whose energy could be
    double lost = 0.0, gained = 0.0;  ///< J, in them
    size_t maxHeapBytes = 0;          ///< of the heap, in use at once
};

/// A loop without a picture; threads: of physics.
FrameLoopSettings stressLoop(int threads);
/// Puts the round's level into a loop, whatever was in it.
void loadRound(const Round& round, FrameLoop& loop);
/// Plays a round from where the loop is, which is just loaded, or a save of that. `onStep` is told after each step.
RoundResult playRound(const Round& round, FrameLoop& loop, const std::function<void()>& onStep);

/// Bytes of the heap in use.
size_t heapBytes();
/// Empties a running loop: bytes in use when nothing is left in it. What clings to it, or to the process, from all that
/// was.
size_t heapBytesWhenEmptied(FrameLoop& loop);
size_t residentBytes();

}  // namespace rubble
