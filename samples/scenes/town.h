#pragma once
#include <cstdint>

#include "runtime/world/level/level.h"

namespace rubble {

/// The town corner, late in the day: a furnished brick house on a corner lot, a shop, a water tower, streets. 64 x 64
/// m. The seed grows the trees; what stands where never changes. Locations: "camera", "camera_house", "camera_street",
/// "player".
Level makeTown(uint64_t seed);

/// The streets with an empty square where the house is, for `model` to stand on: centred there, its lowest voxel on the
/// ground. What of the neighbourhood would touch it is left out. modelLow and modelHigh: its bounds in the stage,
/// metres.
Level makeStreetStage(const Level& model, uint64_t seed, glm::dvec3& modelLow, glm::dvec3& modelHigh);

}  // namespace rubble
