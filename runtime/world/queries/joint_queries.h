#pragma once
#include "runtime/world/state/world_data.h"

namespace rubble {

/// Whether joints lead from a body to the world or to a static body, over any number of other bodies. Loose rope ends
/// and grabs do not count. False if the handle is stale.
bool isJointedToStatic(const WorldData& world, BodyHandle body);

}  // namespace rubble
