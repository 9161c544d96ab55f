#pragma once
#include <string>

#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// A basin with quay walls, fenders and bollards, as a static body, and a water of the same name in it. basin: cells of
/// the level, its top at y = 0; the ground must be left out there. surface: height of the water in metres.
void addQuay(Level& level, const std::string& name, const CellBox& basin, double surface);
/// A static pier of planks on piles, 10 m long, from a cell of the quay's edge over the water, toward +x. depth: cells
/// that the piles reach below the ground.
void addPier(Level& level, const std::string& name, ivec3 cell, int depth);

}  // namespace rubble::scenes
