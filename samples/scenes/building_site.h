#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// A building site, 300 x 260 cells: a frame of concrete with two walls begun, a scaffold, a tower crane (crane.h),
/// piles of bricks, pipes and boards. `cell` is its low corner.
void addBuildingSite(Level& level, ivec3 cell);

}  // namespace rubble::scenes
