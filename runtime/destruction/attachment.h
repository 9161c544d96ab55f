#pragma once
#include <span>
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

/// What no longer belongs to a shape.
struct Loose {
    std::vector<Component> pieces;  ///< that leave it, ordered by their lowest cell
    bool isAdrift = false;          ///< nothing holds to an anchor any more: what stays is the largest component
};

/// What a shape's grid loses. `anchors`: a component that has a cell in one of them stays. None are given for a shape that
/// is free to move: there, and where no component is anchored, the largest stays, else the one with the lowest cell.
Loose findLoose(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored);

/// The same, for a grid in which nothing was loose before the bricks `carved` (each once) lost voxels. Searches from there,
/// nearest to the anchors first, until what was cut is known to be held or all found: costs the cut and the smaller sides
/// of it. Falls back to the whole grid when the search has seen a quarter of it.
Loose findLooseNear(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored, std::span<const glm::ivec3> carved);

}  // namespace rubble
