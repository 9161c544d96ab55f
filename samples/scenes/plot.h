#pragma once
#include "samples/scenes/placement.h"
#include "samples/scenes/street.h"

namespace rubble::scenes {

/// A piece of land for one scene: ground, late sun, and a strip of greenery along its far edge (low z). Sizes in cells.
Level makePlot(std::string name, const GroundPlan& ground, uint64_t seed);
/// An area of the ground from (x0, z0) to (x1, z1).
GroundPlan::Area area(GroundPlan::Surface surface, int x0, int z0, int x1, int z1);
/// Edits place things in metres: a point given in cells.
inline glm::dvec3 atCell(double x, double y, double z) {
    return glm::dvec3(x, y, z) * kVoxel;
}

}  // namespace rubble::scenes
