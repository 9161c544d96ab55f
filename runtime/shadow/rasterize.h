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

/// Sets the cells of shadow brick `brick` that the grid's voxels occupy, by the cellTransform's rule. `bounds` holds
/// all cells that the grid can set.
void rasterize(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, const CellBox& bounds, glm::ivec3 brick,
               CellRows& rows);

/// The cells as words.
ShadowWords packRows(const CellRows& rows);

}  // namespace rubble
