#pragma once
#include <string>

#include "samples/scenes/placement.h"
#include "samples/scenes/street.h"
#include "samples/scenes/surface_styles.h"

/// What the town and the street stage share: crossing streets, and the houses and trees behind them.
namespace rubble::scenes {

/// The box of ground cells from (x0, z0) to (x1, z1), exclusive; y is 0.
inline CellBox groundArea(int x0, int z0, int x1, int z1) {
    return {{x0, 0, z0}, {x1, 0, z1}};
}
/// A ground of size.x by size.z cells with roads, pavements and markings.
GroundPlan crossingStreets(ivec3 size);
/// Adds the houses behind and across the street, street lights and trees.
void addNeighbourhood(Level& level, uint64_t seed);
/// Adds a static tree whose trunk stands at a cell of the ground; `height` in cells.
void addTree(Level& level, const std::string& name, ivec3 foot, int height, const SurfaceStyle& leaves, uint64_t seed);

}  // namespace rubble::scenes
