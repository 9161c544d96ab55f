#pragma once
#include <span>
#include <vector>

#include "runtime/destruction/brick_set.h"
#include "runtime/destruction/components.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

class AttachmentSearch;

/// What no longer belongs to a shape.
struct Detached {
    std::vector<Component> pieces;  ///< that leave it, ordered by their lowest cell
    bool isUnanchored = false;      ///< nothing holds to an anchor any more: what stays is the largest component
};

/// What a shape's grid loses. `anchors`: a component that has a cell in one of them stays. None are given for a shape
/// that is free to move: there, and where no component is anchored, the largest stays, else the one with the lowest
/// cell.
Detached findDetached(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored);

/// The same, for a grid in which nothing was detached before the bricks `carved` lost voxels. Searches from there,
/// nearest to the anchors first, until what was cut is known to be held or all found: costs the cut and the smaller
/// sides of it.
Detached findDetachedNear(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored,
                          const BrickSet& carved);

/// What a search has found that has run to its end.
Detached detachedFrom(AttachmentSearch& search, const VoxelGrid& grid, bool isAnchored);

}  // namespace rubble
