#pragma once
#include <string>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble::bench {

/// Test volumes of size^3 cells: storeys with rooms, doors and windows; a block full of holes; a block full of cracks,
/// connected by bridges of 4x4 cells; a plain block; two halves connected by one bridge. With very many components:
/// cells of a Voronoi diagram with gaps between them, and noise that is solid to 20 and 32 %.
enum class Solid { Building, Holed, Cracked, Block, Halves, Voronoi, Noise20, Noise32 };
inline constexpr const char* kSolidNames[] = {"building", "holed",   "cracked",    "block",
                                              "halves",   "voronoi", "noise 20 %", "noise 32 %"};

/// One of the volumes; `size` is a multiple of 8.
VoxelGrid makeSolid(Solid solid, int size);
/// The same voxels in new bricks without any cached results.
VoxelGrid coldCopy(const VoxelGrid& grid);

}  // namespace rubble::bench
