#pragma once
#include <atomic>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>

#include "runtime/voxel/brick.h"

namespace rubble {

struct NodeMoments;
struct NodeParts;

inline constexpr int kNodeBricks = 4;                       ///< bricks on a side of a directory node
inline constexpr int kNodeSize = kNodeBricks * kBrickSize;  ///< voxels on a side
using BrickMask = uint64_t;                                 ///< of a node's bricks: bit x + 4 y + 16 z
inline constexpr BrickMask kAllBricks = ~BrickMask(0);

/// A brick's bit in the mask of its node; its position may be in the grid or in the node.
constexpr int childIndex(glm::ivec3 brick) {
    return (brick.x & 3) + (brick.y & 3) * 4 + (brick.z & 3) * 16;
}
/// A brick's position in its node.
constexpr glm::ivec3 childPosition(int child) {
    return {child & 3, child >> 2 & 3, child >> 4};
}
/// Calls f(child) for every brick of a mask, in ascending order.
template <class F>
void forEachChild(BrickMask mask, F&& f) {
    for (; mask; mask &= mask - 1) f(std::countr_zero(mask));
}

/// 4x4x4 bricks of a grid's directory. Changed only by a grid that holds it alone: copies of a grid and pieces share
/// it.
struct BrickNode {
    BrickNode();
    BrickNode(const BrickNode& other);
    ~BrickNode();

    BrickMask mask = 0;  ///< which bricks are there
    BrickMask full = 0;  ///< which of them have no empty voxel
    uint32_t voxels = 0;
    uint64_t hash = 0;  ///< sum over bricks of a hash of content and place in the node
    std::array<BrickRef, 64> bricks;

    /// Replaces a brick and keeps the sums; null or empty clears its place.
    void set(int child, BrickRef value);

    // What follows from the bricks, worked out when first asked for.
    mutable Lazy<NodeParts> cachedParts;      ///< see nodeParts()
    mutable Lazy<NodeMoments> cachedMoments;  ///< see nodeMoments()

private:
    friend class NodeRef;
    std::atomic<uint32_t> m_holders = 1;
};

/// A shared node. Not a shared_ptr: its use_count() does not order the other thread's last reads before our write.
class NodeRef {
public:
    NodeRef() = default;
    NodeRef(const NodeRef& other) : m_node(other.m_node) {
        if (m_node) m_node->m_holders.fetch_add(1, std::memory_order_relaxed);
    }
    NodeRef(NodeRef&& other) noexcept : m_node(std::exchange(other.m_node, nullptr)) {}
    NodeRef& operator=(NodeRef other) noexcept {
        std::swap(m_node, other.m_node);
        return *this;
    }
    ~NodeRef() {
        if (m_node && m_node->m_holders.fetch_sub(1, std::memory_order_acq_rel) == 1) delete m_node;
    }
    explicit operator bool() const { return m_node; }
    const BrickNode* operator->() const { return m_node; }
    const BrickNode* get() const { return m_node; }
    /// The node for writing: made if there is none, copied first if others hold it too.
    BrickNode& own() {
        if (!m_node)
            m_node = new BrickNode;
        else if (m_node->m_holders.load(std::memory_order_acquire) != 1)
            *this = NodeRef(new BrickNode(*m_node));
        return *m_node;
    }

private:
    explicit NodeRef(BrickNode* node) : m_node(node) {}
    BrickNode* m_node = nullptr;
};

}  // namespace rubble
