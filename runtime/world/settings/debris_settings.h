#pragma once
#include <cstdint>

namespace rubble {

/// Budgets for debris: pieces on bodies of their own. All are counts, never times: the same edits leave the same debris
/// on every machine. A piece is awake, falls asleep, settles. Beyond a budget pieces despawn as dust: settled ones
/// before sleeping ones before awake ones, small before large, old before young.
struct DebrisSettings {
    uint32_t awakeBodies = 300;        ///< awake pieces
    uint32_t bodies = 10'000;          ///< pieces in all
    uint64_t voxels = 4'000'000;       ///< of all pieces together
    uint64_t largestPiece = 20'000;    ///< voxels; a larger piece is no debris: not counted, never despawned
    uint32_t fragmentsPerBreak = 300;  ///< that one break makes of one shape; beyond, fragments are larger
    uint32_t settleSteps = 120;        ///< a piece that has slept for so long settles: contacts no longer wake it

    friend bool operator==(const DebrisSettings&, const DebrisSettings&) = default;
};

}  // namespace rubble
