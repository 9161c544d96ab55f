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
    int steps = 3600, editsEvery = 10;
    int recordedSteps = 120;       ///< half-way: a save, and these steps recorded, to be loaded and replayed; 0: none
    const Level* level = nullptr;  ///< null: the stress level
};

/// What came of a round.
struct RoundResult {
    std::string wrong;                                                ///< "": all that must hold did
    std::vector<uint64_t> hashes;                                     ///< every 60 steps
    double meanMs = 0.0, medianMs = 0.0, p99Ms = 0.0, worstMs = 0.0;  ///< of processor time, a step
    size_t mostBodies = 0, edits = 0, pieces = 0, removed = 0;
    int compared = 0;                 ///< steps whose energy could be
    double lost = 0.0, gained = 0.0;  ///< J, in them
    size_t mostBytes = 0;             ///< of the heap, in use at once
};

/// A loop without a picture; threads: of physics.
FrameLoopSettings stressLoop(int threads);
/// Puts the round's level into a loop, whatever was in it.
void loadRound(const Round& round, FrameLoop& loop);
/// Plays a round from where the loop is, which is just loaded, or a save of that. `advanced` is told after each step.
RoundResult playRound(const Round& round, FrameLoop& loop, const std::function<void()>& advanced);

/// Bytes of the heap in use.
size_t liveBytes();
/// Empties a running loop: bytes in use when nothing is left in it. What clings to it, or to the process, from all that was.
size_t liveBytesEmptied(FrameLoop& loop);
size_t residentBytes();

}  // namespace rubble
