#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/assets/byte_reader.h"
#include "runtime/world/history/frame_changes.h"

namespace rubble {

/// What a step tells of how it came to its state, which the states before and after it do not: what FrameChanges has
/// under the same names. A world that follows another one has it from there.
struct StepEvents {
    uint64_t step = 0;
    std::vector<RemovedVoxels> removed;
    std::vector<DustCloud> dust;
    std::vector<ShapeSplit> splits;  ///< without their motions
    std::vector<Blast> blasts;
    std::vector<BodyHandle> broken, settled, unsettled;
    uint64_t paintedVoxels = 0;
    bool isRestored = false;

    /// Whether the step tells of nothing.
    bool empty() const;
};

/// Those of a step.
StepEvents eventsOf(const FrameChanges& changes);
/// Adds them to the journal of a world that has followed that step.
void addEvents(const StepEvents& events, FrameChanges& changes);

/// The content of an EVNT chunk. `memory`: gets what reading it takes (MemoryBudget).
std::vector<uint8_t> stepEventsToBytes(const StepEvents& events, uint64_t* memory);
/// Reads it. Handles become those of the World with the number `world`. Fails in the reader.
StepEvents readStepEvents(ByteReader& in, uint8_t world);

}  // namespace rubble
