#pragma once
#include <bit>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "runtime/core/assertion.h"
#include "runtime/voxel/brick_node.h"

namespace rubble {

inline constexpr int kMaxGridSize = 4096;  ///< voxels on a side

/// A sparse grid of voxels in two levels: a dense directory of nodes (4x4x4 bricks each), and bricks of 8x8x8 voxels.
/// Nodes and bricks exist only where voxels are, as in OpenVDB (K. Museth 2013). A copy shares nodes and bricks and
/// copies them on write, so it is cheap. One thread owns a grid; a copy may live on another thread. Coordinates: cells
/// in [0, size), bricks in [0, sizeInBricks), nodes in [0, sizeInNodes).
class VoxelGrid {
public:
    VoxelGrid() = default;
    /// An empty grid of `size` voxels, each component in [1, kMaxGridSize].
    explicit VoxelGrid(glm::ivec3 size);

    /// Voxels along each axis.
    glm::ivec3 size() const { return m_size; }
    /// Bricks along each axis; the last ones may reach beyond size().
    glm::ivec3 sizeInBricks() const { return (m_size + 7) / 8; }
    /// Whether a cell is in [0, size).
    bool contains(glm::ivec3 cell) const {
        return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < m_size.x && cell.y < m_size.y && cell.z < m_size.z;
    }

    /// The palette index of a cell; 0 if it is empty or outside.
    uint8_t at(glm::ivec3 cell) const {
        if (!contains(cell)) return 0;
        const Brick* brick = brickAt(brickOfCell(cell));
        return brick ? brick->at(cellInBrick(cell)) : uint8_t(0);
    }
    /// The brick at a brick coordinate; nullptr if it is empty or outside.
    const Brick* brickAt(glm::ivec3 brick) const {
        const BrickRef* ref = find(brick);
        return ref ? ref->get() : nullptr;
    }
    /// The same as a reference that keeps the brick alive.
    BrickRef shareBrick(glm::ivec3 brick) const {
        const BrickRef* ref = find(brick);
        return ref ? *ref : nullptr;
    }
    /// Whether a directory node holds no brick. The node must be in [0, sizeInNodes).
    bool nodeEmpty(glm::ivec3 node) const { return !m_nodes[nodeIndex(node)]; }
    /// Directory nodes along each axis.
    glm::ivec3 sizeInNodes() const { return m_nodeSize; }
    /// The node at a node coordinate; nullptr if it is empty or outside.
    const BrickNode* nodeAt(glm::ivec3 node) const {
        return node.x < 0 || node.y < 0 || node.z < 0 || node.x >= m_nodeSize.x || node.y >= m_nodeSize.y ||
                       node.z >= m_nodeSize.z
                   ? nullptr
                   : m_nodes[nodeIndex(node)].get();
    }
    /// Removes a node that is not empty, with all its bricks, and returns it.
    NodeRef takeNode(glm::ivec3 node);
    /// Inserts a node that is not empty where none is. Its voxels outside size() must be empty.
    void putNode(glm::ivec3 node, NodeRef value);
    /// Replaces a brick; an empty or null one removes it. Its voxels outside size() must be empty.
    void setBrick(glm::ivec3 brick, BrickRef value);

    /// Whether no voxel is solid.
    bool empty() const { return m_voxels == 0; }
    /// Solid voxels.
    uint64_t voxelCount() const { return m_voxels; }
    /// Bricks that hold voxels.
    size_t brickCount() const { return m_bricks; }
    /// A sum over nodes of a hash of position and content, updated by every write: equal grids have equal hashes.
    uint64_t contentHash() const { return m_hash; }
    /// Bytes of the directory and of all nodes and bricks, shared ones included.
    size_t memoryBytes() const;

    /// Calls f(glm::ivec3 brick, const BrickRef&) for every brick that holds voxels: by node (z, y, x), then by
    /// childIndex().
    template <class F>
    void forEachBrick(F&& f) const {
        for (size_t n = 0; n < m_nodes.size(); ++n) {
            if (!m_nodes[n]) continue;
            const glm::ivec3 base = nodePosition(n) * kNodeBricks;
            for (uint64_t mask = m_nodes[n]->mask; mask; mask &= mask - 1) {
                const int i = std::countr_zero(mask);
                f(base + childPosition(i), m_nodes[n]->bricks[i]);
            }
        }
    }
    /// Calls f(glm::ivec3 node, const BrickNode&) for every node that holds voxels, by z, then y, then x.
    template <class F>
    void forEachNode(F&& f) const {
        for (size_t n = 0; n < m_nodes.size(); ++n)
            if (m_nodes[n]) f(nodePosition(n), *m_nodes[n].get());
    }
    /// Calls f(glm::ivec3 brick) for every brick that is another object than in `other`, a grid of equal size. The
    /// order is that of forEachBrick(). The cost grows with the nodes that the two do not share.
    template <class F>
    void forEachUnshared(const VoxelGrid& other, F&& f) const {
        RUBBLE_ASSERT(m_size == other.m_size);
        for (size_t n = 0; n < m_nodes.size(); ++n) {
            const BrickNode *a = m_nodes[n].get(), *b = other.m_nodes[n].get();
            if (a == b) continue;
            const glm::ivec3 base = nodePosition(n) * kNodeBricks;
            for (uint64_t mask = (a ? a->mask : 0) | (b ? b->mask : 0); mask; mask &= mask - 1) {
                const int i = std::countr_zero(mask);
                if ((a ? a->bricks[i].get() : nullptr) != (b ? b->bricks[i].get() : nullptr))
                    f(base + childPosition(i));
            }
        }
    }

private:
    const BrickRef* find(glm::ivec3 brick) const {
        const glm::ivec3 node = nodeOfBrick(brick);
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
    /// Adds a node to the sums.
    void count(glm::ivec3 position, const BrickNode& node);
    /// Takes a node off the sums.
    void discount(glm::ivec3 position, const BrickNode& node);

    glm::ivec3 m_size{0};
    glm::ivec3 m_nodeSize{0};
    std::vector<NodeRef> m_nodes;
    uint64_t m_voxels = 0;
    uint64_t m_hash = 0;
    size_t m_bricks = 0;
};

/// Collects writes of single voxels and builds each touched brick once, on flush() or in its destructor. Nothing else
/// may change the grid meanwhile.
class GridWriter {
public:
    /// `grid` must outlive the writer.
    explicit GridWriter(VoxelGrid& grid);
    ~GridWriter() { flush(); }
    GridWriter(const GridWriter&) = delete;
    GridWriter& operator=(const GridWriter&) = delete;

    /// Sets a cell to a palette index (0 empties it) and a paint byte. Cells outside the grid are ignored.
    void set(glm::ivec3 cell, uint8_t index, uint8_t paint = 0);
    /// The palette index of a cell, pending writes included.
    uint8_t at(glm::ivec3 cell) const;
    /// Writes all pending cells to the grid.
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
    std::vector<uint32_t> m_lookup;  ///< by brick: its index in m_pending plus one; 0: none
};

}  // namespace rubble
