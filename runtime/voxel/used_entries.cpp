#include "runtime/voxel/used_entries.h"

#include "runtime/voxel/brick_entries.h"

namespace rubble {

const UsedEntries& usedEntries(const BrickNode& node) {
    if (const UsedEntries* known = node.cachedEntries.find()) return *known;
    auto found = std::make_unique<UsedEntries>();
    forEachChild(node.mask, [&](int child) {
        const Brick& brick = *node.bricks[size_t(child)];
        forEachEntry(brick, brick.occupancy, [&](uint8_t entry, size_t, uint64_t) { found->insert(entry); });
    });
    return node.cachedEntries.keep(std::move(found));
}

UsedEntries usedEntries(const VoxelGrid& grid) {
    UsedEntries out;
    grid.forEachNode([&](glm::ivec3, const BrickNode& node) { out.insert(usedEntries(node)); });
    return out;
}

}  // namespace rubble
