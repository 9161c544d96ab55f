#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// Steel legs of the water tower, in cells from its low corner on the ground: a charge at their feet brings it down.
struct WaterTowerPlan {
    static constexpr int kSide = 48;  ///< of the square it stands on
    static constexpr int kLegHeight = 98;
    static constexpr int kTankHeight = 40;
    static constexpr ivec3 kLegs[4] = {{4, 0, 4}, {41, 0, 4}, {4, 0, 41}, {41, 0, 41}};
};
void addWaterTower(Level& level, const std::string& name, ivec3 cell);

}  // namespace rubble::scenes
