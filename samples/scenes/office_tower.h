#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// Measures of the office tower, in cells.
struct OfficeTower {
    static constexpr int kSide = 64, kHeight = 26, kStoreys = 9, kColumn = 5;
    /// Low corners of its columns along x and along z; in its middle is a lift instead.
    static constexpr int kColumns[3] = {0, (kSide - kColumn) / 2, kSide - kColumn};
};

/// A static tower of nine storeys on columns, with a lift shaft; `cell` is where its low corner meets the ground.
void addOfficeTower(Level& level, ivec3 cell);
/// The same with a lift: a body "lift" with the tag "lift=STOREYS HEIGHT" (in metres), which slides on a joint with a
/// motor, and a light over each of its doors. A wire in the shaft feeds these; where they are out the lift has no
/// power.
void addOfficeTowerWithLift(Level& level, ivec3 cell);

}  // namespace rubble::scenes
