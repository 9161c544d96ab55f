#pragma once
#include <string>

#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// Sizes of the water tower, and where its legs stand, in cells from its low corner on the ground.
struct WaterTowerPlan {
    static constexpr int kSide = 48;  ///< of the square it stands on
    static constexpr int kLegHeight = 98;
    static constexpr int kTankHeight = 40;
    static constexpr ivec3 kLegs[4] = {{4, 0, 4}, {41, 0, 4}, {4, 0, 41}, {41, 0, 41}};
};
/// Adds a static water tower on four steel legs; its low corner is at a cell of the ground.
void addWaterTower(Level& level, const std::string& name, ivec3 cell);

}  // namespace rubble::scenes
