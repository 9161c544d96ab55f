#include "runtime/world/history/grid_patch.h"

#include "runtime/core/assertion.h"

namespace rubble {

GridPatch::GridPatch(VoxelGrid was, const VoxelGrid& now) : m_nowHash(now.contentHash()) {
    RUBBLE_ASSERT(was.size() == now.size());
    const glm::ivec3 size = was.sizeInNodes();
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 node{x, y, z};
                if (was.nodeAt(node) == now.nodeAt(node)) continue;
                m_entries.push_back({node, was.nodeEmpty(node) ? NodeRef() : was.takeNode(node)});
            }
    m_entries.shrink_to_fit();
}

VoxelGrid GridPatch::applyTo(VoxelGrid now) const {
    RUBBLE_ASSERT(now.contentHash() == m_nowHash);
    for (const Entry& entry : m_entries) {
        if (!now.nodeEmpty(entry.node)) now.takeNode(entry.node);
        if (entry.was) now.putNode(entry.node, entry.was);
    }
    return now;
}

}  // namespace rubble
