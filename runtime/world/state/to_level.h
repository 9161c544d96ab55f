#pragma once
#include "runtime/world/level/level.h"
#include "runtime/world/state/world_state.h"

namespace rubble {

/// The whole world as a level: loading it gives the same hash of bodies and voxels. Names and tags are those that edits
/// have given. Lights, joints and supplies name shapes and groups by number where a name would not do. What burns,
/// waits or moves inside a rope is not in it, nor the settings; see WorldState for that.
Level toLevel(const WorldState& world);

}  // namespace rubble
