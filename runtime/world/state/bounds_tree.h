#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/world/objects/world_box.h"

namespace rubble {

/// Numbered boxes, found by place: a binary tree of bounds kept good by rotations (Catto, "Dynamic Bounding Volume
/// Hierarchies", GDC 2019). Placing, moving and finding cost the depth of the tree, whatever it holds.
/// A box is kept with a margin, so that small moves cost a comparison: what is found is near, not exact, and in no
/// order.
class BoundsTree {
public:
    /// Inserts the item, or moves it. A box with a NaN is nowhere.
    void update(uint32_t item, const WorldBox& box);
    void remove(uint32_t item);
    void clear() { *this = {}; }

    /// f(item) for every item whose box may satisfy isNear(box), which must hold for a box if it holds for a part of
    /// it.
    template <class IsNear, class F>
    void find(IsNear&& isNear, F&& f) const {
        if (m_root == kNone) return;
        std::vector<uint32_t> open{m_root};
        while (!open.empty()) {
            const Node& node = m_nodes[open.back()];
            open.pop_back();
            if (!isNear(node.box)) continue;
            if (node.isLeaf())
                f(node.item);
            else
                open.insert(open.end(), {node.left, node.right});
        }
    }
    int depth() const;

private:
    static constexpr uint32_t kNone = ~0u;
    struct Node {
        WorldBox box;
        uint32_t parent = kNone, left = kNone, right = kNone, item = kNone;
        bool isLeaf() const { return left == kNone; }
    };
    uint32_t allocate();
    uint32_t bestSibling(const WorldBox& box) const;
    void insertLeaf(uint32_t leaf);
    void removeLeaf(uint32_t leaf);
    void replaceChild(uint32_t parent, uint32_t old, uint32_t by);
    /// Brings the boxes from here to the root up to date and rotates where that makes them smaller.
    void refit(uint32_t node);
    void rotate(uint32_t node);
    /// What the area of `child` shrinks by if its sibling's place is taken by one of its children.
    void trySwap(uint32_t child, uint32_t& sibling, double& best, std::pair<uint32_t*, uint32_t*>& swap);

    std::vector<Node> m_nodes;
    std::vector<uint32_t> m_free;
    std::vector<uint32_t> m_leafOf;  ///< by item
    uint32_t m_root = kNone;
};

}  // namespace rubble
