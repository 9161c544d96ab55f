#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/core/world_box.h"

namespace rubble {

/// A dynamic tree of axis-aligned boxes (Catto, "Dynamic Bounding Volume Hierarchies", GDC 2019). A leaf is an item's
/// box; an inner node is the box around its two children. A new leaf becomes the sibling of the node that makes the
/// total area grow least, and on the path back to the root rotations swap a node with its sibling's child where that
/// shrinks a box: the area heuristic, by which a node is visited with a probability proportional to its surface area.
/// Where many boxes are in one place that says nothing, so rotations also keep the heights of two children within a
/// limit, as in an AVL tree: the depth is O(log n). Insertion, moves and searches cost the depth of the tree. Boxes are
/// kept with a margin, so that a small move costs a comparison: what is found is near, not exact, in no order.
class BoundsTree {
public:
    /// Inserts an item or moves it. An item whose box has a NaN is removed.
    void update(uint32_t item, const WorldBox& box);
    /// Removes an item, if it is there.
    void remove(uint32_t item);
    /// Removes all items.
    void clear() { *this = {}; }

    /// Calls f(item) for every item whose box, margin included, satisfies isNear(box). isNear must be true for a box if
    /// it is true for a part of it.
    template <class IsNear, class F>
    void find(IsNear&& isNear, F&& f) const {
        uint32_t at = m_root;
        while (at != kNone) {
            const Node& node = m_nodes[at];
            if (!isNear(node.box)) {
                at = nextOf(at);
            } else if (!node.isLeaf()) {
                at = node.right;
            } else {
                f(node.item);
                at = nextOf(at);
            }
        }
    }
    /// Nodes on the longest path from the root.
    int depth() const;

private:
    static constexpr uint32_t kNone = ~0u;
    struct Node {
        WorldBox box;
        uint32_t parent = kNone, left = kNone, right = kNone, item = kNone;
        int height = 0;  ///< edges to its deepest leaf
        /// Whether it holds an item.
        bool isLeaf() const { return left == kNone; }
    };
    /// The node after a node and all below it, from right to left; kNone: there is none.
    uint32_t nextOf(uint32_t node) const {
        for (uint32_t parent = m_nodes[node].parent; parent != kNone; node = parent, parent = m_nodes[node].parent)
            if (m_nodes[parent].left != node) return m_nodes[parent].left;
        return kNone;
    }
    uint32_t allocate();
    uint32_t bestSibling(const WorldBox& box) const;
    void insertLeaf(uint32_t leaf);
    void removeLeaf(uint32_t leaf);
    void replaceChild(uint32_t parent, uint32_t old, uint32_t by);
    /// Updates the boxes from here to the root, with a rotation at each node that has a good one.
    void refit(uint32_t node);
    void update(Node& node) const;
    void rotate(uint32_t node);
    /// A rotation: a grandchild and its parent's sibling, which change places.
    struct Rotation {
        uint32_t *goes = nullptr, *sibling = nullptr;
        double saved = 0.0;  ///< area
    };
    /// Tests the rotations that swap `sibling` with a child of `child`; keeps the one that saves the most area of those
    /// that leave the tree balanced. If `child` is too high, one of them is made in any case.
    void tryRotations(uint32_t child, uint32_t& sibling, Rotation& best);

    std::vector<Node> m_nodes;
    std::vector<uint32_t> m_free;
    std::vector<uint32_t> m_leafOf;  ///< by item
    uint32_t m_root = kNone;
};

}  // namespace rubble
