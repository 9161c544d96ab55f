#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/shadow/shadow_cell_transform.h"
#include "runtime/shadow/shadow_volume.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The cells of one shadow brick as rows along x: row y + 16 z, bit x.
using CellRows = std::array<uint16_t, kShadowBrickCells * kShadowBrickCells>;

/// The shadow bricks that a box of shadow cells touches.
inline CellBox shadowBricksOf(const CellBox& cells) {
    return {cells.low >> 4, (cells.high + (kShadowBrickCells - 1)) >> 4};
}

/// Adds to `rows` the cells of shadow brick `brick` that the grid's voxels set (ShadowCellTransform says which).
/// bounds: a box that contains all cells that the grid can set.
void rasterize(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, const CellBox& bounds, glm::ivec3 brick,
               CellRows& rows);

/// The same for the cells of a box, row by row: of any shape whose voxels are not cells.
/// corner: the cell that row 0 and bit 0 stand for. box: at most 16 cells wide from there.
void rasterizeByRows(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, const CellBox& box,
                     glm::ivec3 corner, CellRows& rows);

/// The same cells as words of 4x4x4.
ShadowWords packRows(const CellRows& rows);

}  // namespace rubble
