#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// Measures of the steel bridge, in cells: its length along z, its width along x, and how deep its abutments reach.
struct SteelBridge {
    static constexpr int kLength = 184, kWidth = 112, kDepth = 22, kAbutment = 10;
};
/// A static through truss bridge with a road and two footways, level with the ground; `cell` is the low corner of its
/// deck. Its abutments hold it, nothing else does.
void addSteelBridge(Level& level, ivec3 cell);

}  // namespace rubble::scenes
