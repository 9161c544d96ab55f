#include "runtime/destruction/detachment.h"

#include <algorithm>

#include "runtime/destruction/attachment_search.h"

namespace rubble {
namespace {

/// Removes the largest component from the list: it stays.
void removeLargest(std::vector<Component>& pieces) {
    if (pieces.empty()) return;
    pieces.erase(std::min_element(pieces.begin(), pieces.end(), isLargerComponent));
}

}  // namespace

Detached findDetached(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored) {
    Detached detached{findComponents(grid), false};
    if (isAnchored) {
        const size_t all = detached.pieces.size();
        std::erase_if(detached.pieces,
                      [&](const Component& component) { return touchesAnchor(grid, component, anchors); });
        detached.isUnanchored = detached.pieces.size() == all && all > 0;
        if (!detached.isUnanchored) return detached;
    }
    removeLargest(detached.pieces);
    return detached;
}

Detached detachedFrom(AttachmentSearch& search, const VoxelGrid& grid, bool isAnchored) {
    Detached detached{search.finished(grid), false};
    uint64_t rest = grid.voxelCount();
    for (const Component& piece : detached.pieces) rest -= piece.voxels;
    detached.isUnanchored = isAnchored && rest == 0 && !detached.pieces.empty();
    if (detached.isUnanchored || (!isAnchored && !search.hasUnfinished())) removeLargest(detached.pieces);
    return detached;
}

}  // namespace rubble
