#pragma once
#include <cstdint>

#include "runtime/world/state/world_state.h"

namespace rubble {

/// Where every voxel of the level is now.
struct VoxelAccounting {
    uint64_t imported = 0;  ///< voxels that the level brought
    uint64_t standing = 0;  ///< in shapes that came with the level
    uint64_t inPieces = 0;  ///< in shapes that came off, or lost their last anchor
    uint64_t removed = 0;   ///< gone
    /// imported = standing + inPieces + removed: true after every step.
    bool balances() const { return imported == standing + inPieces + removed; }
};

/// Adds up all shapes; costs their number.
VoxelAccounting voxelAccounting(const WorldState& world);

}  // namespace rubble
