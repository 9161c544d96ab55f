#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// Measures of the museum, in cells.
struct MuseumPlan {
    static constexpr int kWidth = 200, kDepth = 128, kSteps = 14;  ///< of its plinth, and of the steps before it
};
/// A static hall of stone with a vault of glass and a portico toward +z, lit inside, with exhibits: a skeleton, busts,
/// vases and a meteorite. `cell` is the low corner of its plinth.
void addMuseum(Level& level, ivec3 cell);

}  // namespace rubble::scenes
