#pragma once
#include <string>

#include "samples/scenes/placement.h"
#include "samples/scenes/street.h"

namespace rubble::scenes {

/// A level with ground, a late sun, and trees and a hedge along its far edge (low z).
Level makePlot(std::string name, const GroundPlan& ground, uint64_t seed);
/// An area of the ground from (x0, z0) to (x1, z1), exclusive, in cells.
GroundPlan::Area area(GroundPlan::Surface surface, int x0, int z0, int x1, int z1);
/// A point in metres, as edits take it, given in cells.
inline glm::dvec3 atCell(double x, double y, double z) {
    return glm::dvec3(x, y, z) * kVoxel;
}

}  // namespace rubble::scenes
