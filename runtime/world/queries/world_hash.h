#pragma once
#include <cstdint>

#include "runtime/world/state/world_data.h"

namespace rubble {

// Hashes of a world, in slot order. The number of the world and the generations of its slots are in none of them.

/// A hash of all that decides what happens next: resolvedHash(), the step, heat, ropes, pending splits and stress
/// analyses.
uint64_t stateHash(const WorldData& world);
/// A hash of all objects, weather, materials, settings and bounds, without the step, heat, and work that goes on over
/// steps: what the outcome of a recorded step adds up to, and what an undo restores.
uint64_t resolvedHash(const WorldState& world);
/// A hash of voxels, palettes and light groups alone: the same on every machine.
uint64_t voxelHash(const WorldState& world);

}  // namespace rubble
