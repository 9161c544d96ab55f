#pragma once
#include "runtime/world/state/world_data.h"

namespace rubble {

/// Where a joint's free motion is: of a hinge its angle in radians, -pi to pi; of a prismatic joint or a wheel its
/// travel in metres; of a ball or a cone the angle between its ends' axes, 0 to pi; of a rope the distance of its ends
/// in metres; of a fixed joint 0. All but a rope's are 0 in the pose in which the joint was made.
double jointMovement(const WorldData& world, const Joint& joint);
/// Whether joints lead from a body to the world or to a static body, over any number of other bodies. Loose rope ends
/// and grabs do not count. False if the handle is stale.
bool isJointedToStatic(const WorldData& world, BodyHandle body);

}  // namespace rubble
