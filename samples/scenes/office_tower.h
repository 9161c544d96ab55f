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

}  // namespace rubble::scenes
