#pragma once
#include <bitset>
#include <vector>

#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"
#include "runtime/world/level/level.h"

namespace rubble {

inline constexpr int kRegionSize = 32;  ///< cells on a side of a region, whose boxes are merged together

/// The palette entries that bodies collide with: all but those of unphysical materials.
using SolidEntries = std::bitset<256>;
/// By the materials of the table.
SolidEntries solidEntries(const Palette& palette, const MaterialTable& materials);

/// Disjoint boxes that cover exactly the solid cells of one region (region * 32 to region * 32 + 32), appended to
/// `out`. Greedy: a run along x, widened along y, then along z, from the lowest cell on.
void mergeRegion(const VoxelGrid& grid, glm::ivec3 region, const SolidEntries& solid, std::vector<CellBox>& out);
/// The same for a whole grid; boxes are joined across the borders of regions.
std::vector<CellBox> mergeGrid(const VoxelGrid& grid, const SolidEntries& solid);
/// Joins boxes that share a whole face, along x, then y, then z.
void joinBoxes(std::vector<CellBox>& boxes);
/// A grid of half the resolution: a cell is solid if at least half of its eight are. The cell's index is that of one of
/// them.
VoxelGrid halveGrid(const VoxelGrid& grid, const SolidEntries& solid);

}  // namespace rubble
