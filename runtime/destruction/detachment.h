#pragma once
#include <span>
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

class AttachmentSearch;

/// The parts of a shape that are no longer connected to it.
struct Detached {
    std::vector<Component> pieces;  ///< that leave the shape, ordered by their lowest cell
    bool isUnanchored = false;      ///< no component touches an anchor any more; the largest one stays
};

/// Finds what leaves a grid, from all of its voxels. A component stays if one of its cells lies in one of the
/// `anchors`. Where no component does, and in a shape that is free to move (not `isAnchored`), the largest stays; of
/// equal ones that with the lowest cell.
Detached findDetached(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored);

/// The same from a search outward from a cut, whose run() has returned true. The search costs the cut and the smaller
/// sides of it, not the grid.
Detached detachedFrom(AttachmentSearch& search, const VoxelGrid& grid, bool isAnchored);

}  // namespace rubble
