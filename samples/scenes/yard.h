#pragma once
#include <cstdint>

#include "runtime/world/level/level.h"

namespace rubble {

/// A yard to drive in, 64 x 48 m: concrete, a brick house that may fall, a heap of earth, a harbour basin with a pier.
/// Locations: "player", and "vehicle KIND" for each of the game's vehicles.
Level makeYard(uint64_t seed);

/// Adds the places of the vehicles of makeDistrict().
void addDistrictVehicles(Level& level);

}  // namespace rubble
