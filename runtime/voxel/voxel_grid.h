#pragma once
#include <cassert>
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/voxel/brick_node.h"

namespace rubble {

inline constexpr int kMaxGridSize = 4096;  ///< voxels on a side

/// A sparse grid of voxels: shared bricks under a two-level directory (nodes of 4x4x4 bricks, allocated where something
/// is). Owned by one thread. A copy shares directory nodes and bricks until either is written, and may live on another
/// thread. Coordinates: cells in [0, size); bricks in [0, sizeInBricks).
class VoxelGrid {
public:
    VoxelGrid() = default;
    /// size in voxels, each in [1, kMaxGridSize].
    explicit VoxelGrid(glm::ivec3 size);

    glm::ivec3 size() const { return m_size; }
    glm::ivec3 sizeInBricks() const { return (m_size + 7) / 8; }
    bool contains(glm::ivec3 cell) const {
        return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < m_size.x && cell.y < m_size.y && cell.z < m_size.z;
    }

    /// Palette index of a cell; 0 if empty or outside.
    uint8_t at(glm::ivec3 cell) const {
        if (!contains(cell)) return 0;
        const Brick* brick = brickAt(cell >> 3);
        return brick ? brick->at(cell & 7) : uint8_t(0);
    }
    /// nullptr if the brick is empty or outside.
    const Brick* brickAt(glm::ivec3 brick) const {
        const BrickRef* ref = find(brick);
        return ref ? ref->get() : nullptr;
    }
    BrickRef shareBrick(glm::ivec3 brick) const {
        const BrickRef* ref = find(brick);
        return ref ? *ref : nullptr;
    }
    /// True if none of the 4x4x4 bricks of a directory node (its coordinates are brick >> 2) is there.
    bool nodeEmpty(glm::ivec3 node) const { return !m_nodes[nodeIndex(node)]; }
    glm::ivec3 sizeInNodes() const { return m_nodeSize; }
    /// nullptr if the node is empty or outside.
    const BrickNode* nodeAt(glm::ivec3 node) const {
        return node.x < 0 || node.y < 0 || node.z < 0 || node.x >= m_nodeSize.x || node.y >= m_nodeSize.y ||
                       node.z >= m_nodeSize.z
                   ? nullptr
                   : m_nodes[nodeIndex(node)].get();
    }
    /// Takes a node out of the grid: whole, by reference.
    NodeRef takeNode(glm::ivec3 node);
    /// Puts a node, which must not be empty, where none is. Voxels outside size() must be empty.
    void putNode(glm::ivec3 node, NodeRef value);
    /// Replaces a brick; an empty or null one clears its place. Voxels outside size() must be empty.
    void setBrick(glm::ivec3 brick, BrickRef value);

    bool empty() const { return m_voxels == 0; }
    uint64_t voxelCount() const { return m_voxels; }
    size_t brickCount() const { return m_bricks; }
    /// Sum over nodes of a hash of place and content, kept up to date: equal grids have equal hashes.
    uint64_t contentHash() const { return m_hash; }
    /// Bytes of the directory and of the bricks it holds (shared ones counted in full).
    size_t memoryBytes() const;

    /// f(ivec3 brick, const BrickRef&) for every brick that holds something, in a fixed order.
    template <class F>
    void forEachBrick(F&& f) const {
        for (size_t n = 0; n < m_nodes.size(); ++n) {
            if (!m_nodes[n]) continue;
            const glm::ivec3 base = nodePosition(n) * 4;
            for (uint64_t mask = m_nodes[n]->mask; mask; mask &= mask - 1) {
                const int i = std::countr_zero(mask);
                f(base + childPosition(i), m_nodes[n]->bricks[i]);
            }
        }
    }
    /// f(ivec3 node, const BrickNode&) for every node that holds something, in the same order: by z, then y, then x.
    template <class F>
    void forEachNode(F&& f) const {
        for (size_t n = 0; n < m_nodes.size(); ++n)
            if (m_nodes[n]) f(nodePosition(n), *m_nodes[n].get());
    }
    /// f(ivec3 brick) for every brick that is not the same object as in `other`, a grid of equal size, in a fixed
    /// order. Costs the nodes that the two do not share.
    template <class F>
    void forEachUnshared(const VoxelGrid& other, F&& f) const {
        assert(m_size == other.m_size);
        for (size_t n = 0; n < m_nodes.size(); ++n) {
            const BrickNode *a = m_nodes[n].get(), *b = other.m_nodes[n].get();
            if (a == b) continue;
            const glm::ivec3 base = nodePosition(n) * 4;
            for (uint64_t mask = (a ? a->mask : 0) | (b ? b->mask : 0); mask; mask &= mask - 1) {
                const int i = std::countr_zero(mask);
                if ((a ? a->bricks[i].get() : nullptr) != (b ? b->bricks[i].get() : nullptr))
                    f(base + childPosition(i));
            }
        }
    }

private:
    const BrickRef* find(glm::ivec3 brick) const {
        const glm::ivec3 node = brick >> 2;
        if (brick.x < 0 || brick.y < 0 || brick.z < 0 || node.x >= m_nodeSize.x || node.y >= m_nodeSize.y ||
            node.z >= m_nodeSize.z)
            return nullptr;
        const auto& found = m_nodes[nodeIndex(node)];
        return found ? &found->bricks[childIndex(brick)] : nullptr;
    }
    size_t nodeIndex(glm::ivec3 node) const { return (size_t(node.z) * m_nodeSize.y + node.y) * m_nodeSize.x + node.x; }
    glm::ivec3 nodePosition(size_t n) const {
        return {int(n % m_nodeSize.x), int(n / m_nodeSize.x % m_nodeSize.y), int(n / m_nodeSize.x / m_nodeSize.y)};
    }
    /// Adds a node to the sums, or takes it off.
    void count(glm::ivec3 position, const BrickNode& node);
    void discount(glm::ivec3 position, const BrickNode& node);

    glm::ivec3 m_size{0};
    glm::ivec3 m_nodeSize{0};
    std::vector<NodeRef> m_nodes;
    uint64_t m_voxels = 0;
    uint64_t m_hash = 0;
    size_t m_bricks = 0;
};

/// Collects single-voxel writes to a grid and makes each touched brick once, when it is destroyed or flushed.
/// The grid must not be changed by others meanwhile.
class GridWriter {
public:
    explicit GridWriter(VoxelGrid& grid);
    ~GridWriter() { flush(); }
    GridWriter(const GridWriter&) = delete;
    GridWriter& operator=(const GridWriter&) = delete;

    /// Cells outside the grid are ignored. Index 0 empties. A cell that is set has this paint and no other.
    void set(glm::ivec3 cell, uint8_t index, uint8_t paint = 0);
    /// The value with the pending writes.
    uint8_t at(glm::ivec3 cell) const;
    void flush();

private:
    struct Pending {
        glm::ivec3 brick;
        BrickIndices indices;
        std::unique_ptr<BrickIndices> paint;  ///< null if the brick had none
    };
    Pending& pendingFor(glm::ivec3 brick);
    VoxelGrid& m_grid;
    std::vector<std::unique_ptr<Pending>> m_pending;
    std::vector<uint32_t> m_lookup;  ///< a brick's place in m_pending plus one
};

}  // namespace rubble
