#include "runtime/destruction/attachment.h"

#include <algorithm>

#include "runtime/destruction/attachment_search.h"

namespace rubble {
namespace {

/// Takes the component that keeps the name out of the list.
void removeKeeper(std::vector<Component>& pieces) {
    if (pieces.empty()) return;
    pieces.erase(std::min_element(pieces.begin(), pieces.end(), outranks));
}

}  // namespace

Loose findLoose(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored) {
    Loose loose{findComponents(grid), false};
    if (isAnchored) {
        const size_t all = loose.pieces.size();
        std::erase_if(loose.pieces, [&](const Component& component) { return touchesAnchor(grid, component, anchors); });
        loose.isAdrift = loose.pieces.size() == all && all > 0;
        if (!loose.isAdrift) return loose;
    }
    removeKeeper(loose.pieces);
    return loose;
}

Loose findLooseNear(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored, const BrickSet& carved) {
    AttachmentSearch search(grid, anchors, isAnchored, carved);
    size_t unlimited = SIZE_MAX;
    search.run(grid, anchors, unlimited);
    return looseFrom(search, grid, isAnchored);
}

Loose looseFrom(AttachmentSearch& search, const VoxelGrid& grid, bool isAnchored) {
    Loose loose{search.finished(grid), false};
    uint64_t rest = grid.voxelCount();
    for (const Component& piece : loose.pieces) rest -= piece.voxels;
    loose.isAdrift = isAnchored && rest == 0 && !loose.pieces.empty();
    if (loose.isAdrift || (!isAnchored && !search.hasOpen())) removeKeeper(loose.pieces);
    return loose;
}

}  // namespace rubble
