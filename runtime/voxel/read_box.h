#pragma once
#include <glm/vec3.hpp>
#include <span>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// What readBox() reads of a cell.
enum class CellByte { Index, Paint };

/// One byte for each cell of a box, x fastest, then y, then z: its palette index or its paint byte; 0 for cells that
/// are empty or outside the grid. `out`: as many bytes as the box has cells. Rows of full bricks are copied whole.
void readBox(const VoxelGrid& grid, const CellBox& box, CellByte what, std::span<uint8_t> out);

}  // namespace rubble
