#pragma once
#include "runtime/destruction/components.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

/// A component in a grid of its own. Cell c of it was cell c + offset of the grid it came from; the offset is a
/// multiple of the brick size, so that whole bricks are taken over by reference.
struct Piece {
    VoxelGrid grid;
    glm::ivec3 offset{0};
};

/// Moves a component out of the grid. Bricks that belong wholly to it are shared, not copied.
Piece takePiece(VoxelGrid& grid, const Component& component);

/// The smallest box that holds all voxels of a grid that is not empty.
CellBox filledBounds(const VoxelGrid& grid);

/// The cells of a box of a grid, which may reach beyond it, as a grid of their own: cell c was cell c + box.low. Shares
/// the bricks where it can: all but those at the border, if the low corner is a multiple of the brick size.
VoxelGrid cropped(const VoxelGrid& grid, const CellBox& box);

}  // namespace rubble
