#pragma once
#include <string>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble::bench {

/// Solids that cuts meet, of size^3 cells: storeys with rooms, doors and windows; a block full of holes; one full of
/// cracks that bridges of 4x4 cells hold together; a plain block; two halves on one bridge. And what has a great many
/// components: cells of a Voronoi diagram with gaps between them, and noise of which 20 and 32 % are solid.
enum class Solid { Building, Holed, Cracked, Block, Halves, Voronoi, Noise20, Noise32 };
inline constexpr const char* kSolidNames[] = {"building", "holed",   "cracked",    "block",
                                              "halves",   "voronoi", "noise 20 %", "noise 32 %"};

VoxelGrid makeSolid(Solid solid, int size);
/// The same voxels in bricks of their own, about which nothing is known yet.
VoxelGrid coldCopy(const VoxelGrid& grid);

}  // namespace rubble::bench
