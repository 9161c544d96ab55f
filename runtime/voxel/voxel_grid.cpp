#include "runtime/voxel/voxel_grid.h"

#include <utility>

#include "runtime/core/assertion.h"
#include "runtime/core/hash.h"

namespace rubble {
namespace {

uint64_t hashNode(glm::ivec3 node, const BrickNode& content) {
    const int32_t position[3] = {node.x, node.y, node.z};
    return hashBytes(position, sizeof position, content.hash);
}

}  // namespace

VoxelGrid::VoxelGrid(glm::ivec3 size) : m_size(size), m_nodeSize((size + kNodeSize - 1) / kNodeSize) {
    RUBBLE_ASSERT(size.x > 0 && size.y > 0 && size.z > 0 && size.x <= kMaxGridSize && size.y <= kMaxGridSize &&
                  size.z <= kMaxGridSize);
    m_nodes.resize(size_t(m_nodeSize.x) * m_nodeSize.y * m_nodeSize.z);
}

void VoxelGrid::setBrick(glm::ivec3 brick, BrickRef value) {
    RUBBLE_ASSERT(brick.x >= 0 && brick.y >= 0 && brick.z >= 0 && brick.x * 8 < m_size.x && brick.y * 8 < m_size.y &&
                  brick.z * 8 < m_size.z);
    const glm::ivec3 position = nodeOfBrick(brick);
    NodeRef& node = m_nodes[nodeIndex(position)];
    if (!node && !value) return;
    if (node) discount(position, *node.get());
    node.own().set(childIndex(brick), std::move(value));
    if (node->mask)
        count(position, *node.get());
    else
        node = {};
}

NodeRef VoxelGrid::takeNode(glm::ivec3 node) {
    NodeRef& entry = m_nodes[nodeIndex(node)];
    RUBBLE_ASSERT(entry && "expected a node that holds voxels");
    discount(node, *entry.get());
    return std::exchange(entry, {});
}

void VoxelGrid::putNode(glm::ivec3 node, NodeRef value) {
    NodeRef& entry = m_nodes[nodeIndex(node)];
    RUBBLE_ASSERT(value && !entry && "expected a node that holds voxels and an empty entry for it");
    entry = std::move(value);
    count(node, *entry.get());
}

void VoxelGrid::count(glm::ivec3 position, const BrickNode& node) {
    m_voxels += node.voxels;
    m_bricks += size_t(std::popcount(node.mask));
    m_hash += hashNode(position, node);
}

void VoxelGrid::discount(glm::ivec3 position, const BrickNode& node) {
    m_voxels -= node.voxels;
    m_bricks -= size_t(std::popcount(node.mask));
    m_hash -= hashNode(position, node);
}

size_t VoxelGrid::memoryBytes() const {
    size_t bytes = m_nodes.size() * sizeof(m_nodes[0]);
    for (const auto& node : m_nodes)
        if (node) bytes += sizeof(BrickNode);
    forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        bytes += sizeof(Brick) + 16 + (brick->indices ? kBrickVoxels : 0) + (brick->paint ? kBrickVoxels : 0);
    });
    return bytes;
}

GridWriter::GridWriter(VoxelGrid& grid) : m_grid(grid) {
    const glm::ivec3 bricks = grid.sizeInBricks();
    m_lookup.resize(size_t(bricks.x) * bricks.y * bricks.z);
}

GridWriter::Pending& GridWriter::pendingFor(glm::ivec3 brick) {
    const glm::ivec3 bricks = m_grid.sizeInBricks();
    uint32_t& entry = m_lookup[(size_t(brick.z) * bricks.y + brick.y) * bricks.x + brick.x];
    if (!entry) {
        m_pending.push_back(std::make_unique<Pending>(Pending{brick, {}, nullptr}));
        const Brick* before = m_grid.brickAt(brick);
        expandBrick(before, m_pending.back()->indices);
        if (before && before->paint) m_pending.back()->paint = std::make_unique<BrickIndices>(*before->paint);
        entry = uint32_t(m_pending.size());
    }
    return *m_pending[entry - 1];
}

void GridWriter::set(glm::ivec3 cell, uint8_t index, uint8_t paint) {
    if (!m_grid.contains(cell)) return;
    Pending& pending = pendingFor(brickOfCell(cell));
    const size_t voxel = size_t(voxelIndex(cellInBrick(cell)));
    pending.indices[voxel] = index;
    if (paint && !pending.paint) pending.paint = std::make_unique<BrickIndices>(BrickIndices{});
    if (pending.paint) (*pending.paint)[voxel] = paint;
}

uint8_t GridWriter::at(glm::ivec3 cell) const {
    if (!m_grid.contains(cell)) return 0;
    const glm::ivec3 bricks = m_grid.sizeInBricks();
    const glm::ivec3 brick = brickOfCell(cell);
    const uint32_t pending = m_lookup[(size_t(brick.z) * bricks.y + brick.y) * bricks.x + brick.x];
    return pending ? m_pending[pending - 1]->indices[voxelIndex(cellInBrick(cell))] : m_grid.at(cell);
}

void GridWriter::flush() {
    const glm::ivec3 bricks = m_grid.sizeInBricks();
    for (const auto& pending : m_pending) {
        m_grid.setBrick(pending->brick, makeBrick(pending->indices, pending->paint.get()));
        m_lookup[(size_t(pending->brick.z) * bricks.y + pending->brick.y) * bricks.x + pending->brick.x] = 0;
    }
    m_pending.clear();
}

}  // namespace rubble
