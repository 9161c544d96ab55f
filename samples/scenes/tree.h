#pragma once
#include "samples/scenes/canvas.h"

namespace rubble::scenes {

/// A broad-leaved tree `height` cells high; roots reach kTreeRoot cells into the ground. Its trunk stands in the middle
/// of the shape.
inline constexpr int kTreeRoot = 3;
LevelShape makeTree(std::string name, int height, const SurfaceStyle& leaves, uint64_t seed);
/// A clipped hedge along x or z, two cells into the ground.
inline constexpr int kHedgeRoot = 2;
LevelShape makeHedge(std::string name, ivec3 size);

}  // namespace rubble::scenes
