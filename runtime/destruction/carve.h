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

/// The voxels that carves removed from one grid. Several carves add up.
struct CarveResult {
    std::vector<glm::ivec3> bricks;       ///< that lost voxels; a brick may occur once in each carve
    std::array<uint64_t, 256> removed{};  ///< voxels by palette entry
    uint64_t voxels = 0;                  ///< sum of `removed`
    CellBox cells;                        ///< the smallest box of all removed voxels
    MassMoments moments;                  ///< of all removed voxels, in cells of the grid

    /// Adds a brick and the box of its removed voxels.
    void addBrick(const BrickSubset& gone) {
        bricks.push_back(gone.brick);
        cells = joined(cells, voxelBounds(gone.brick, gone.voxels));
    }
};

/// Removes the voxels that the brush touches, each class of hardness within its own radius. Unbreakable and unphysical
/// voxels stay, and those that the tool does not break. Adds to `out`. The cost grows with the bricks in the brush's
/// bounds.
void carve(VoxelGrid& grid, const Brush& brush, const Palette& palette, const MaterialTable& materials,
           CarveResult& out, Tool tool = Tool::Any);

/// How many voxels carve() would remove.
uint64_t countCarved(const VoxelGrid& grid, const Brush& brush, const Palette& palette, const MaterialTable& materials,
                     Tool tool = Tool::Any);

/// Removes exactly these voxels, of any material. Adds to `out`.
void removeCells(VoxelGrid& grid, const BrickSubset& cells, const Densities& densities, CarveResult& out);

}  // namespace rubble
