#pragma once
#include <string>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble::bench {

/// Solids that cuts meet, of size^3 cells: storeys with rooms, doors and windows; a block full of holes; one full of cracks
/// that bridges of 4x4 cells hold together; a plain block; two halves on one bridge.
enum class Solid { Building, Holed, Cracked, Block, Halves };
inline constexpr const char* kSolidNames[] = {"building", "holed", "cracked", "block", "halves"};

VoxelGrid makeSolid(Solid solid, int size);
/// The same voxels in bricks of their own, about which nothing is known yet.
VoxelGrid coldCopy(const VoxelGrid& grid);

}  // namespace rubble::bench
