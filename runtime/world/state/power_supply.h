#pragma once
#include "runtime/world/state/world_data.h"

namespace rubble {

/// Whether wire leads from a light group's supply to one of the group's voxels. False if the supply's shape is gone.
bool isPowered(const WorldData& world, LightGroupHandle handle, const LightGroup& group);

}  // namespace rubble
