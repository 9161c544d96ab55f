#include "runtime/world/state/bounds_tree.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kMargin = 0.2;  ///< metres: a falling body changes the tree every few steps only

bool isNumber(const WorldBox& box) {
    return box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z;
}

}  // namespace

void BoundsTree::update(uint32_t item, const WorldBox& box) {
    if (m_leafOf.size() <= item) m_leafOf.resize(item + 1, kNone);
    uint32_t leaf = m_leafOf[item];
    if (leaf != kNone && m_nodes[leaf].box.contains(box)) return;
    if (!isNumber(box)) return remove(item);
    if (leaf == kNone)
        leaf = m_leafOf[item] = allocate();
    else
        removeLeaf(leaf);
    m_nodes[leaf].item = item;
    m_nodes[leaf].box = {box.low - kMargin, box.high + kMargin};
    insertLeaf(leaf);
}

void BoundsTree::remove(uint32_t item) {
    if (item >= m_leafOf.size() || m_leafOf[item] == kNone) return;
    const uint32_t leaf = std::exchange(m_leafOf[item], kNone);
    removeLeaf(leaf);
    m_free.push_back(leaf);
}

int BoundsTree::depth() const {
    int deepest = 0;
    for (uint32_t i = 0; i < m_nodes.size(); ++i) {
        int depth = 0;
        for (uint32_t node = i; node != kNone; node = m_nodes[node].parent) ++depth;
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

uint32_t BoundsTree::allocate() {
    if (m_free.empty()) {
        m_nodes.emplace_back();
        return uint32_t(m_nodes.size() - 1);
    }
    const uint32_t node = m_free.back();
    m_free.pop_back();
    m_nodes[node] = {};
    return node;
}

/// Descends to where the new box adds the least area to all boxes above it.
uint32_t BoundsTree::bestSibling(const WorldBox& box) const {
    uint32_t at = m_root;
    while (!m_nodes[at].isLeaf()) {
        const Node& node = m_nodes[at];
        const double joined = node.box.merged(box).area();
        const double inherited = joined - node.box.area();
        const auto cost = [&](uint32_t child) {
            const double area = m_nodes[child].box.merged(box).area();
            return inherited + (m_nodes[child].isLeaf() ? area : area - m_nodes[child].box.area());
        };
        const double left = cost(node.left), right = cost(node.right);
        if (joined < left && joined < right) break;
        at = left <= right ? node.left : node.right;
    }
    return at;
}

void BoundsTree::insertLeaf(uint32_t leaf) {
    m_nodes[leaf].parent = kNone;
    if (m_root == kNone) {
        m_root = leaf;
        return;
    }
    const uint32_t sibling = bestSibling(m_nodes[leaf].box);
    const uint32_t above = m_nodes[sibling].parent, inner = allocate();
    m_nodes[inner].parent = above;
    m_nodes[inner].left = sibling;
    m_nodes[inner].right = leaf;
    m_nodes[sibling].parent = m_nodes[leaf].parent = inner;
    replaceChild(above, sibling, inner);
    refit(inner);
}

void BoundsTree::removeLeaf(uint32_t leaf) {
    const uint32_t inner = m_nodes[leaf].parent;
    if (inner == kNone) {
        m_root = kNone;
        return;
    }
    const uint32_t sibling = m_nodes[inner].left == leaf ? m_nodes[inner].right : m_nodes[inner].left;
    const uint32_t above = m_nodes[inner].parent;
    m_nodes[sibling].parent = above;
    replaceChild(above, inner, sibling);
    m_free.push_back(inner);
    refit(above);
}

void BoundsTree::replaceChild(uint32_t parent, uint32_t old, uint32_t by) {
    uint32_t& place = parent == kNone               ? m_root
                      : m_nodes[parent].left == old ? m_nodes[parent].left
                                                    : m_nodes[parent].right;
    place = by;
}

void BoundsTree::refit(uint32_t node) {
    for (; node != kNone; node = m_nodes[node].parent) {
        Node& each = m_nodes[node];
        each.box = m_nodes[each.left].box.merged(m_nodes[each.right].box);
        rotate(node);
    }
}

void BoundsTree::trySwap(uint32_t child, uint32_t& sibling, double& best, std::pair<uint32_t*, uint32_t*>& swap) {
    Node& node = m_nodes[child];
    if (node.isLeaf()) return;
    const double now = node.box.area();
    const auto consider = [&](uint32_t& goes, uint32_t stays) {
        const double saved = now - m_nodes[stays].box.merged(m_nodes[sibling].box).area();
        if (saved > best) best = saved, swap = {&goes, &sibling};
    };
    consider(node.left, node.right);
    consider(node.right, node.left);
}

void BoundsTree::rotate(uint32_t at) {
    Node& node = m_nodes[at];
    double best = 0.0;
    std::pair<uint32_t*, uint32_t*> swap{nullptr, nullptr};
    trySwap(node.left, node.right, best, swap);
    trySwap(node.right, node.left, best, swap);
    if (!swap.first) return;
    const uint32_t below = m_nodes[*swap.first].parent;
    std::swap(*swap.first, *swap.second);
    m_nodes[*swap.first].parent = below;
    m_nodes[*swap.second].parent = at;
    m_nodes[below].box = m_nodes[m_nodes[below].left].box.merged(m_nodes[m_nodes[below].right].box);
}

}  // namespace rubble
