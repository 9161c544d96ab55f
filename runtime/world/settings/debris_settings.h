#pragma once
#include <cstdint>

namespace rubble {

/// Budgets of what has come off. All are counts, never times: the same edits leave the same debris on every machine.
/// Debris is a piece on a body of its own. It is awake, falls asleep, settles, and is dust when a budget asks for its
/// place: settled pieces before sleeping ones before those that move, small before large, old before young.
struct DebrisSettings {
    uint32_t awakeBodies = 300;        ///< pieces that move at the same time
    uint32_t bodies = 10'000;          ///< pieces in all
    uint64_t voxels = 4'000'000;       ///< in all pieces together
    uint64_t largestPiece = 20'000;    ///< voxels; what is larger is no debris: not counted, never turned to dust
    uint32_t fragmentsPerBreak = 300;  ///< that one break makes of one shape: beyond, they are larger
    uint32_t settleSteps = 120;        ///< a piece that has slept that many steps settles: a touch no longer wakes it

    friend bool operator==(const DebrisSettings&, const DebrisSettings&) = default;
};

}  // namespace rubble
