#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// A wooden barn, 124 x 96 cells, with a loft, two doors on hinges toward +z and bales of hay. `cell` is where the low
/// corner of its walls meets the ground.
void addBarn(Level& level, ivec3 cell);

}  // namespace rubble::scenes
