#pragma once
#include <cstdint>

#include "runtime/world/level/level.h"

namespace rubble {

/// The town of makeTown() as one of four blocks, 144 x 128 m, late in the day: houses with rooms, an office tower with
/// a lift, a building site with a crane, a petrol station, a museum, a canal with a steel bridge and a pier, a barn,
/// and a power line that feeds street lights. What is in the town has the same places and names. Only trees depend on
/// the seed. Locations: those of the town, "camera_district", "camera_canal", "camera_museum", "camera_station",
/// "camera_site".
Level makeDistrict(uint64_t seed);

}  // namespace rubble
