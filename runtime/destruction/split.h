#pragma once
#include "runtime/destruction/components.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

/// Voxels in a grid of their own. Its cell c was cell c + offset of the grid it came from.
struct Piece {
    VoxelGrid grid;
    glm::ivec3 offset{0};
};

/// Moves a component out of a grid into a grid of its own. Bricks, and in large pieces nodes, that belong to it as a
/// whole are shared, not copied: so the offset is a multiple of the brick size, or of the node size.
Piece takePiece(VoxelGrid& grid, const Component& component);

/// The smallest box that holds all voxels of a grid that is not empty.
CellBox filledBounds(const VoxelGrid& grid);

/// The cells of a box, which may reach beyond the grid, as a grid of their own: its cell c was cell c + box.low. If
/// box.low is a multiple of the brick size, bricks inside the box are shared; others are copied.
VoxelGrid cropped(const VoxelGrid& grid, const CellBox& box);

}  // namespace rubble
