#pragma once
#include "samples/scenes/placement.h"
#include "samples/scenes/street.h"
#include "samples/scenes/surface_styles.h"

/// What every stage shares: the crossing streets, and the houses and trees behind.
namespace rubble::scenes {

inline CellBox groundArea(int x0, int z0, int x1, int z1) {
    return {{x0, 0, z0}, {x1, 0, z1}};
}
/// Roads, pavements and markings on a ground of size.x by size.z cells.
GroundPlan crossingStreets(ivec3 size);
/// The row of houses behind, the one across, street lamps and trees.
void addNeighbourhood(Level& level, uint64_t seed);
/// A tree whose trunk stands at a cell of the ground.
void addTree(Level& level, const std::string& name, ivec3 foot, int height, const SurfaceStyle& leaves, uint64_t seed);

}  // namespace rubble::scenes
