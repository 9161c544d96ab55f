#pragma once
#include <array>
#include <map>
#include <vector>

#include "runtime/destruction/components.h"

namespace rubble {

/// A set of bricks of one grid, stored by directory node, so that a set of many bricks stays small. Iterates by node
/// (z, y, x), then by childIndex().
class BrickSet {
public:
    /// Adds one brick.
    void insert(glm::ivec3 brick) { insert(nodeOfBrick(brick), BrickMask(1) << childIndex(brick)); }
    /// Adds bricks of one node. An empty mask still adds the node to forEachNode().
    void insert(glm::ivec3 node, BrickMask bricks) { m_nodes[{node.z, node.y, node.x}] |= bricks; }
    /// Adds all bricks of another set.
    void insert(const BrickSet& other) {
        for (const auto& [key, mask] : other.m_nodes) m_nodes[key] |= mask;
    }
    /// Adds all bricks that hold voxels of a component.
    void insert(const Component& component) {
        for (const NodeSubset& subset : component.nodes) insert(subset.node, subset.bricks);
        for (const BrickSubset& subset : component.subsets) insert(subset.brick);
    }
    /// Whether no node was inserted.
    bool empty() const { return m_nodes.empty(); }
    /// Removes all bricks.
    void clear() { m_nodes.clear(); }
    /// The bricks of a node that are in the set.
    BrickMask at(glm::ivec3 node) const {
        const auto found = m_nodes.find({node.z, node.y, node.x});
        return found == m_nodes.end() ? 0 : found->second;
    }

    /// Calls f(glm::ivec3 node, BrickMask) for each node.
    template <class F>
    void forEachNode(F&& f) const {
        for (const auto& [key, mask] : m_nodes) f(glm::ivec3(key[2], key[1], key[0]), mask);
    }
    /// Calls f(glm::ivec3 brick) for each brick.
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
