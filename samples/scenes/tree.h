#pragma once
#include <string>

#include "samples/scenes/canvas.h"

namespace rubble::scenes {

inline constexpr int kTreeRoot = 3;   ///< depth of a tree's roots in cells
inline constexpr int kHedgeRoot = 2;  ///< depth of a hedge's roots in cells

/// A broad-leaved tree, `height` cells high over the ground, its trunk in the middle of the shape.
LevelShape makeTree(std::string name, int height, const SurfaceStyle& leaves, uint64_t seed);
/// A clipped hedge along x or z; `size` in cells over the ground.
LevelShape makeHedge(std::string name, ivec3 size);

}  // namespace rubble::scenes
