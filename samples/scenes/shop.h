#pragma once
#include "samples/scenes/building.h"

namespace rubble::scenes {

/// A flat-roofed shop, its glass front toward +z, with goods inside, an awning and a lit sign ("<name> sign" is its
/// group).
struct ShopPlan {
    static constexpr int kWidth = 120, kDepth = 100, kMargin = 6, kFront = 16;
};
/// `cell` is where the low corner of its walls meets the ground.
void addShop(Level& level, const std::string& name, ivec3 cell);

}  // namespace rubble::scenes
