#pragma once
#include <string>

#include "samples/scenes/building.h"

namespace rubble::scenes {

/// Sizes of the shop, in cells: of its walls, and of the shape around them and in front of them.
struct ShopPlan {
    static constexpr int kWidth = 120, kDepth = 100, kMargin = 6, kFront = 16;
};
/// Adds a static shop with a flat roof: its glass front toward +z, goods inside, an awning, and a lit sign whose light
/// group is "<name> sign". `cell` is where the low corner of its walls meets the ground.
void addShop(Level& level, const std::string& name, ivec3 cell);

}  // namespace rubble::scenes
