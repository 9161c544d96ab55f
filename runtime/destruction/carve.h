#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/destruction/brush.h"
#include "runtime/destruction/components.h"
#include "runtime/voxel/mass_properties.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// What carves took out of one grid; several carves add up.
struct CarveResult {
    std::vector<glm::ivec3> bricks;       ///< that changed; a brick may occur once a carve
    std::array<uint64_t, 256> removed{};  ///< voxels by palette entry
    uint64_t voxels = 0;
    CellBox cells;        ///< that held what was removed
    MassMoments moments;  ///< of what was removed

    /// Notes a brick and where in it voxels went.
    void addBrick(const BrickSubset& gone) {
        bricks.push_back(gone.brick);
        cells = joined(cells, voxelBounds(gone.brick, gone.voxels));
    }
};

/// Empties the cells that the brush touches, each class of hardness within its own radius; unbreakable and unphysical
/// voxels stay, and those that the tool does not break. Costs the bricks within the brush's bounds.
void carve(VoxelGrid& grid, const Brush& brush, const Palette& palette, const MaterialTable& materials,
           CarveResult& out, Tool tool = Tool::Any);

/// Empties exactly these cells, whatever they are made of.
void removeCells(VoxelGrid& grid, const BrickSubset& cells, const Densities& densities, CarveResult& out);

}  // namespace rubble
