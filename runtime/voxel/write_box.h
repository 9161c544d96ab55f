#pragma once
#include <span>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// What a write makes of a brick.
struct BrickWrite {
    BrickRef before, after;  ///< null: no voxel
    BrickBits changed{};     ///< cells whose palette index is another now
    /// Whether an index changed.
    bool any() const { return changed != BrickBits{}; }
    /// The cells that changed and had a voxel.
    BrickBits lost() const { return solid(before); }
    /// The cells that changed and have a voxel now.
    BrickBits made() const { return solid(after); }

private:
    BrickBits solid(const BrickRef& brick) const {
        BrickBits out{};
        for (size_t z = 0; brick && z < 8; ++z) out[z] = changed[z] & brick->occupancy[z];
        return out;
    }
};

/// The brick at a brick coordinate with palette indices written over the cells of a box within the grid: a byte each
/// cell of the box, x fastest, then y, then z; 0 empties it. `mask`: in the same order, 0 where a cell is not written;
/// empty: all are. Cells whose index stays keep their paint. The grid is not changed.
BrickWrite writtenBrick(const VoxelGrid& grid, glm::ivec3 brick, const CellBox& box, std::span<const uint8_t> indices,
                        std::span<const uint8_t> mask = {});

}  // namespace rubble
