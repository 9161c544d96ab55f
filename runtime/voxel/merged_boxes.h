#pragma once
#include <bitset>
#include <vector>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// Boxes that hold the voxels of these palette entries, each once, and no other cell. Rows of voxels that are equal
/// side by side are one rectangle, and rectangles that are equal in layers one box. In the order of their last layers,
/// z. Costs the grid's bricks and the boxes.
std::vector<CellBox> mergedBoxes(const VoxelGrid& grid, const std::bitset<256>& entries);

}  // namespace rubble
