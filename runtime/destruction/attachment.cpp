#include "runtime/destruction/attachment.h"

#include <algorithm>
#include <glm/common.hpp>

#include "runtime/destruction/attachment_search.h"

namespace rubble {
namespace {

bool touchesAnchor(const Component& component, std::span<const CellBox> anchors) {
    return std::any_of(component.shares.begin(), component.shares.end(), [&](const BrickShare& share) { return touchesAnchor(share, anchors); });
}

/// Takes the component that keeps the name out of the list.
void removeKeeper(std::vector<Component>& pieces) {
    if (pieces.empty()) return;
    pieces.erase(std::min_element(pieces.begin(), pieces.end(), outranks));
}

}  // namespace

bool touchesAnchor(const BrickShare& share, std::span<const CellBox> anchors) {
    const glm::ivec3 base = share.brick * kBrickSize;
    for (const CellBox& anchor : anchors) {
        const glm::ivec3 low = glm::max(anchor.low - base, 0), high = glm::min(anchor.high - base, kBrickSize);
        if (low.x >= high.x || low.y >= high.y || low.z >= high.z) continue;
        const uint64_t row = (uint64_t(1) << high.x) - (uint64_t(1) << low.x);
        uint64_t layer = 0;
        for (int y = low.y; y < high.y; ++y) layer |= row << 8 * y;
        for (int z = low.z; z < high.z; ++z)
            if (share.voxels[size_t(z)] & layer) return true;
    }
    return false;
}

Loose findLoose(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored) {
    Loose loose{findComponents(grid), false};
    if (isAnchored) {
        const size_t all = loose.pieces.size();
        std::erase_if(loose.pieces, [&](const Component& component) { return touchesAnchor(component, anchors); });
        loose.isAdrift = loose.pieces.size() == all && all > 0;
        if (!loose.isAdrift) return loose;
    }
    removeKeeper(loose.pieces);
    return loose;
}

Loose findLooseNear(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored, std::span<const glm::ivec3> carved) {
    AttachmentSearch search(grid, isAnchored ? anchors : std::span<const CellBox>{}, carved);
    if (!search.run(isAnchored, grid.brickCount() / 4 + 64)) return findLoose(grid, anchors, isAnchored);
    Loose loose{search.takeFinished(), false};
    uint64_t rest = grid.voxelCount();
    for (const Component& piece : loose.pieces) rest -= piece.voxels;
    loose.isAdrift = isAnchored && rest == 0 && !loose.pieces.empty();
    if (loose.isAdrift || (!isAnchored && !search.hasOpen())) removeKeeper(loose.pieces);
    return loose;
}

}  // namespace rubble
