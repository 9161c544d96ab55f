#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// A static line of wooden poles along x with a street light at each, whose cable is a wire: where it is cut, all
/// lights behind are without power. It is fed at its first pole, at `cell`; `poles` of them stand `spacing` cells
/// apart.
void addPowerLine(Level& level, ivec3 cell, int poles, int spacing);

}  // namespace rubble::scenes
