#pragma once
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>

#include "runtime/voxel/brick.h"

namespace rubble {

struct NodeMoments;
struct NodeParts;
struct UsedEntries;

inline constexpr int kNodeBricks = 4;                       ///< bricks on a side of a directory node
inline constexpr int kNodeSize = kNodeBricks * kBrickSize;  ///< voxels on a side of a directory node
using BrickMask = uint64_t;                                 ///< one bit for each brick of a node: bit x + 4 y + 16 z
inline constexpr BrickMask kAllBricks = ~BrickMask(0);

/// The directory node that holds a brick; along one axis, or all three.
constexpr int nodeOfBrick(int brick) {
    return brick >> 2;
}
/// The directory node that holds a brick of the grid.
constexpr glm::ivec3 nodeOfBrick(glm::ivec3 brick) {
    return brick >> 2;
}
/// A brick's number in its node, 0 to 63: its bit in a BrickMask. The position may be in the grid or in the node.
constexpr int childIndex(glm::ivec3 brick) {
    return (brick.x & 3) + (brick.y & 3) * 4 + (brick.z & 3) * 16;
}
/// The position in its node of the brick with this number, each component 0 to 3.
constexpr glm::ivec3 childPosition(int child) {
    return {child & 3, child >> 2 & 3, child >> 4};
}
/// Calls f(child) for every brick of a mask, in ascending order.
template <class F>
void forEachChild(BrickMask mask, F&& f) {
    for (; mask; mask &= mask - 1) f(std::countr_zero(mask));
}

/// 4x4x4 bricks of a grid's directory, with sums over them. Copies of a grid and detached pieces share nodes; only a
/// grid that holds a node alone may change it (NodeRef::own()).
struct BrickNode {
    /// An empty node.
    BrickNode();
    /// A copy for writing: shares the bricks and computes its caches again.
    BrickNode(const BrickNode& other);
    ~BrickNode();

    BrickMask mask = 0;               ///< which bricks hold voxels
    BrickMask full = 0;               ///< which of them have no empty voxel
    uint32_t voxels = 0;              ///< solid voxels of all bricks
    uint64_t hash = 0;                ///< sum over bricks of a hash of content and position in the node
    std::array<BrickRef, 64> bricks;  ///< by childIndex(); null where the mask has no bit

    /// Replaces a brick and updates the sums; a null or empty `value` clears it.
    void set(int child, BrickRef value);

    // Computed from the bricks on first use.
    mutable Lazy<NodeParts> cachedParts;      ///< see nodeParts()
    mutable Lazy<NodeMoments> cachedMoments;  ///< see nodeMoments()
    mutable Lazy<UsedEntries> cachedEntries;  ///< see usedEntries()

private:
    friend class NodeRef;
    std::atomic<uint32_t> m_holders = 1;
};

/// A reference-counted pointer to a node, with copy on write. std::shared_ptr cannot be used: its use_count() does not
/// order another thread's last reads before our write, so it cannot tell safely that we hold the node alone.
class NodeRef {
public:
    NodeRef() = default;
    /// Shares the node.
    NodeRef(const NodeRef& other) : m_node(other.m_node) {
        if (m_node) m_node->m_holders.fetch_add(1, std::memory_order_relaxed);
    }
    /// Takes the node over; `other` is empty.
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
    /// The node for reading; nullptr if there is none.
    const BrickNode* get() const { return m_node; }
    /// The node for writing: created if there is none, copied first if others share it.
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
