#pragma once
#include "runtime/shadow/rasterize.h"

namespace rubble {

/// Whether a shape's voxels are so large, 4 to 7 shadow cells by its rotation, that boxes of cells can be filled as a
/// whole.
bool hasLargeVoxels(const ShadowCellTransform& cellTransform);

/// Adds to `rows` the cells of `box` that the grid's voxels set, as rasterizeByRows() does, for shapes with large
/// voxels. An octree of boxes of cells: one whose samples all lie in solid voxels is filled, one whose samples all lie
/// in empty ones is left out, and another one is divided; the smallest, of 4x4x4 cells, is sampled. The cost follows
/// the surface of the shape, not the cells inside. corner: the cell that row 0 and bit 0 stand for. box: at most 16
/// cells wide from there.
void rasterizeLargeVoxels(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, const CellBox& box,
                          glm::ivec3 corner, CellRows& rows);

}  // namespace rubble
