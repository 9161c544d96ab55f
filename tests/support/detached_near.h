#pragma once
#include <cstdint>
#include <span>

#include "runtime/destruction/attachment_search.h"
#include "runtime/destruction/detachment.h"

namespace rubble::test {

/// findDetached() for a grid in which nothing was detached before the bricks `carved` lost voxels, by one search
/// outward from them without a budget.
inline Detached findDetachedNear(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored,
                                 const BrickSet& carved) {
    AttachmentSearch search(grid, anchors, isAnchored, carved);
    size_t unlimited = SIZE_MAX;
    search.run(grid, anchors, unlimited);
    return detachedFrom(search, grid, isAnchored);
}

}  // namespace rubble::test
