#pragma once
#include "runtime/world/edit.h"
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// Cracks a slab into pieces: thin cuts in rings and spokes around a point, so that what a charge leaves comes off in lumps.
struct Fracture {
    glm::dvec3 center{0.0};
    int normalAxis = 0;           ///< axis across the slab: 0 x, 1 y, 2 z
    double radius = 1.5;          ///< of the outermost ring, metres
    double halfThickness = 0.25;  ///< of the slab, metres
    int spokes = 9;               ///< at most 12
    Hardness hardest = Hardness::Medium;
    uint64_t seed = 1;
};
Edits fracture(const Fracture& crack);

}  // namespace rubble::scenes
