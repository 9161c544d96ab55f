#pragma once
#include "runtime/world/level/level.h"
#include "runtime/world/state/world_data.h"

namespace rubble {

/// Replaces everything by the level; handles from before go stale. Hidden shapes are left out. Static shapes without
/// anchors are anchored by their lowest layer of voxels. Joints that find no voxel to hold on to are left out and
/// logged.
void loadLevel(WorldData& world, const Level& level);

/// The whole world as a level: loading it gives the same hash of bodies and voxels. What burns, waits or moves inside a
/// rope is not in it; see WorldState for that.
Level toLevel(const WorldState& world);

}  // namespace rubble
