#pragma once
#include <cstdint>

#include "runtime/world/level/level.h"

namespace rubble {

/// The town corner, late in the day, 64 x 64 m: a furnished brick house on a corner lot, a shop, a water tower,
/// streets. Only the trees depend on the seed. Locations: "camera", "camera_house", "camera_street", "player".
Level makeTown(uint64_t seed);

/// The streets with a square instead of the house. `model` stands in its middle, its lowest voxel on the ground; bodies
/// that would overlap it are left out. modelLow and modelHigh receive its bounds on the stage, in metres.
Level makeStreetStage(const Level& model, uint64_t seed, glm::dvec3& modelLow, glm::dvec3& modelHigh);

}  // namespace rubble
