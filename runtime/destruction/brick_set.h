#pragma once
#include <map>
#include <vector>

#include "runtime/destruction/components.h"

namespace rubble {

/// A set of bricks of one grid, by directory node: a large one costs its nodes. Iterates by node (z, y, x), then by
/// brick.
class BrickSet {
public:
    void insert(glm::ivec3 brick) { insert(brick >> 2, BrickMask(1) << childIndex(brick)); }
    void insert(glm::ivec3 node, BrickMask bricks) { m_nodes[{node.z, node.y, node.x}] |= bricks; }
    void insert(const BrickSet& other) {
        for (const auto& [key, mask] : other.m_nodes) m_nodes[key] |= mask;
    }
    void insert(const Component& component) {
        for (const NodeSubset& subset : component.nodes) insert(subset.node, subset.bricks);
        for (const BrickSubset& subset : component.subsets) insert(subset.brick);
    }
    bool empty() const { return m_nodes.empty(); }
    void clear() { m_nodes.clear(); }
    BrickMask at(glm::ivec3 node) const {
        const auto found = m_nodes.find({node.z, node.y, node.x});
        return found == m_nodes.end() ? 0 : found->second;
    }

    /// f(ivec3 node, BrickMask).
    template <class F>
    void forEachNode(F&& f) const {
        for (const auto& [key, mask] : m_nodes) f(glm::ivec3(key[2], key[1], key[0]), mask);
    }
    /// f(ivec3 brick).
    template <class F>
    void forEach(F&& f) const {
        forEachNode([&](glm::ivec3 node, BrickMask mask) {
            forEachChild(mask, [&](int child) { f(node * kNodeBricks + childPosition(child)); });
        });
    }
    friend bool operator==(const BrickSet&, const BrickSet&) = default;

private:
    std::map<std::array<int, 3>, BrickMask> m_nodes;  ///< z, y, x
};

}  // namespace rubble
