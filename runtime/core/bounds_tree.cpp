#include "runtime/core/bounds_tree.h"

#include <algorithm>
#include <cstdlib>

namespace rubble {
namespace {

constexpr int kMaxImbalance = 4;  ///< difference of height of two children that rotations leave
constexpr double kMargin = 0.2;   ///< metres: a falling body changes the tree every few steps only

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
        const bool isLeftHigher = m_nodes[node.left].height > m_nodes[node.right].height;
        at = left < right || (left == right && !isLeftHigher) ? node.left : node.right;
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
        update(m_nodes[node]);
        rotate(node);
    }
}

/// Takes over box and height of its children.
void BoundsTree::update(Node& node) const {
    const Node &left = m_nodes[node.left], &right = m_nodes[node.right];
    node.box = left.box.merged(right.box);
    node.height = 1 + std::max(left.height, right.height);
}

void BoundsTree::tryRotations(uint32_t child, uint32_t& sibling, Rotation& best) {
    Node& node = m_nodes[child];
    if (node.isLeaf()) return;
    const int across = m_nodes[sibling].height;
    const bool isTooHigh = node.height - across > kMaxImbalance;
    if (isTooHigh) best = {};
    const auto consider = [&](uint32_t& goes, uint32_t stays) {
        const int up = m_nodes[goes].height, beside = m_nodes[stays].height;
        const double saved = node.box.area() - m_nodes[stays].box.merged(m_nodes[sibling].box).area();
        const bool isBalanced =
            std::abs(across - beside) <= kMaxImbalance && std::abs(up - 1 - std::max(across, beside)) <= kMaxImbalance;
        if (isTooHigh ? up > beside || (up == beside && (!best.goes || saved > best.saved))
                      : isBalanced && saved > best.saved)
            best = {&goes, &sibling, saved};
    };
    consider(node.left, node.right);
    consider(node.right, node.left);
}

void BoundsTree::rotate(uint32_t at) {
    Node& node = m_nodes[at];
    Rotation best;
    const bool leftIsHigher = m_nodes[node.left].height > m_nodes[node.right].height;
    leftIsHigher ? tryRotations(node.right, node.left, best) : tryRotations(node.left, node.right, best);
    leftIsHigher ? tryRotations(node.left, node.right, best) : tryRotations(node.right, node.left, best);
    if (!best.goes) return;
    const uint32_t below = m_nodes[*best.goes].parent;
    std::swap(*best.goes, *best.sibling);
    m_nodes[*best.goes].parent = below;
    m_nodes[*best.sibling].parent = at;
    update(m_nodes[below]);
    update(node);
}

}  // namespace rubble
