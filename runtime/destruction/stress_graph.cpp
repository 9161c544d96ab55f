#include "runtime/destruction/stress_graph.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "runtime/voxel/brick_box.h"

namespace rubble {
namespace {

constexpr double kMaxNeckRatio = 0.6;  ///< area of a neck over that of the widest layer on its narrower side

/// A plane between two layers of a brick. ratio: its area over that of the widest layer on its narrower side.
struct Neck {
    int axis = 0, plane = 0;
    double ratio = 1.0;
};

/// The plane of the smallest ratio; of several that follow each other, the one in the middle.
Neck narrowest(const BrickBits& cells) {
    Neck best;
    for (int axis = 0; axis < 3; ++axis) {
        std::array<uint64_t, 8> layers;
        std::array<int, 8> widestBelow, widestAbove;
        for (int k = 0; k < 8; ++k) layers[size_t(k)] = brickLayer(cells, axis, k);
        for (size_t k = 0, widest = 0; k < 8; ++k)
            widestBelow[k] = int(widest = std::max(widest, size_t(std::popcount(layers[k]))));
        for (size_t k = 8, widest = 0; k-- > 0;)
            widestAbove[k] = int(widest = std::max(widest, size_t(std::popcount(layers[k]))));
        int first = 0, last = 0;
        double smallest = 1.0;
        for (size_t k = 1; k < 8; ++k) {
            const int beside = std::min(widestBelow[k - 1], widestAbove[k]);
            if (!beside) continue;
            const double ratio = double(std::popcount(layers[k - 1] & layers[k])) / beside;
            if (ratio < smallest) smallest = ratio, first = int(k);
            if (ratio == smallest) last = int(k);
        }
        if (smallest < best.ratio) best = {axis, (first + last) / 2, smallest};
    }
    return best;
}

}  // namespace

StrengthTable makeStrengthTable(const Palette& palette, const MaterialTable& materials) {
    StrengthTable out;
    for (size_t i = 1; i < 256; ++i) {
        const Material& material = materials[palette[i].material];
        out[i] = {double(material.density),
                  material.tensileStrength,
                  material.compressiveStrength,
                  material.shearStrength,
                  material.hardness != Hardness::Unphysical,
                  material.hardness < Hardness::Unbreakable};
    }
    return out;
}

BrickBits solidCells(const Brick& brick, const StrengthTable& entries) {
    if (!brick.indices) return entries[brick.uniform].isSolid ? brick.occupancy : BrickBits{};
    BrickBits out = brick.occupancy;
    forEachVoxel(brick.occupancy, [&](int i) {
        if (!entries[(*brick.indices)[size_t(i)]].isSolid) clearVoxel(out, i);
    });
    return out;
}

BrickBits anchoredCells(glm::ivec3 brick, std::span<const CellBox> anchors) {
    BrickBits out{};
    for (const CellBox& anchor : anchors) {
        const BrickBits inside = cellsInBox(brick, anchor);
        for (size_t z = 0; z < 8; ++z) out[z] |= inside[z];
    }
    return out;
}

SectionStrength sectionStrength(const VoxelGrid& grid, const StrengthTable& entries, const Section& section,
                                bool& canBreak) {
    glm::ivec3 step(0);
    step[section.axis] = 1;
    const Brick* low = grid.brickAt(section.brick);
    const Brick* high = section.plane < 8 ? low : grid.brickAt(section.brick + step);
    SectionStrength sum;
    canBreak = false;
    if (!low || !high) return {};  // the bricks have changed since the section was made
    int faces = 0;
    const auto add = [&](const EntryStrength& a, const EntryStrength& b, int count) {
        canBreak = canBreak || a.canBreak || b.canBreak;
        sum.tensile += count * std::min(a.tensile, b.tensile);
        sum.compressive += count * std::min(a.compressive, b.compressive);
        sum.shear += count * std::min(a.shear, b.shear);
        faces += count;
    };
    if (!low->indices && !high->indices)
        add(entries[low->uniform], entries[high->uniform], std::popcount(section.cells));
    else
        for (uint64_t left = section.cells; left; left &= left - 1) {
            const glm::ivec3 cell = section.cellBelow(std::countr_zero(left));
            add(entries[low->at(cellInBrick(cell))], entries[high->at(cellInBrick(cell + step))], 1);
        }
    return {sum.tensile / faces, sum.compressive / faces, sum.shear / faces};
}

void StressGraph::setBrick(const VoxelGrid& grid, std::span<const CellBox> anchors, const StrengthTable& entries,
                           glm::ivec3 brick) {
    removeNodes(brick);
    m_added.clear();
    if (const Brick* content = grid.brickAt(brick)) addNodes(*content, anchors, entries, brick);
    connectBrick(grid, entries, brick);
    for (const uint32_t node : m_added) inheritDisplacement(m_nodes[node]);
}

void StressGraph::removeNodes(glm::ivec3 brick) {
    m_removed.clear();
    for (uint32_t node = m_firstNode.find(brickKey(brick)); node != kNoIndex; node = m_nodes[node].nextInBrick) {
        m_removed.push_back(m_nodes[node]);
        while (m_nodes[node].firstBond != kNoIndex) removeBond(m_nodes[node].firstBond);
        m_nodes[node].isUsed = false;
        m_nodeSlots.free(node);
    }
}

void StressGraph::removeBond(uint32_t index) {
    const StressBond& bond = m_bonds[index];
    for (const uint32_t end : {bond.below, bond.above}) {
        uint32_t* link = &m_nodes[end].firstBond;
        uint32_t before = kNoIndex;
        for (; *link != index; link = &m_bonds[before].nextOf(end)) before = *link;
        *link = bond.nextOf(end);
        if (m_nodes[end].lastBond == index) m_nodes[end].lastBond = before;
    }
    m_bondSlots.free(index);
}

void StressGraph::addNodes(const Brick& content, std::span<const CellBox> anchors, const StrengthTable& entries,
                           glm::ivec3 brick) {
    const BrickBits solid = solidCells(content, entries), anchored = anchoredCells(brick, anchors);
    BrickBits fixed, free;
    for (size_t z = 0; z < 8; ++z) fixed[z] = solid[z] & anchored[z], free[z] = solid[z] & ~anchored[z];
    m_parts.clear(), m_bodies.clear();
    findBrickParts(free, m_parts);
    for (size_t i = 0, count = m_parts.size(); i < count; ++i) splitAtNecks(BrickBits(m_parts[i].voxels));
    for (const BrickBits& cells : m_bodies) addNode(content, entries, brick, cells, false);
    if (fixed != BrickBits{}) addNode(content, entries, brick, fixed, true);
}

/// Adds the parts of a connected set of cells to m_bodies. It is cut at necks: planes with much less area than the
/// widest layers on both sides. A rigid node cannot deform at a neck, a bond can.
void StressGraph::splitAtNecks(const BrickBits& cells) {
    const Neck neck = narrowest(cells);
    if (neck.ratio > kMaxNeckRatio) return m_bodies.push_back(cells);
    const BrickBits above = bitsFrom(cells, neck.axis, neck.plane);
    BrickBits below;
    for (size_t z = 0; z < 8; ++z) below[z] = cells[z] & ~above[z];
    const size_t first = m_parts.size();
    findBrickParts(below, m_parts);
    findBrickParts(above, m_parts);
    for (size_t i = first, end = m_parts.size(); i < end; ++i) splitAtNecks(BrickBits(m_parts[i].voxels));
    m_parts.resize(first);
}

void StressGraph::addNode(const Brick& content, const StrengthTable& entries, glm::ivec3 brick, const BrickBits& cells,
                          bool isFixed) {
    const uint32_t index = m_nodeSlots.allocate();
    if (index == m_nodes.size()) m_nodes.emplace_back();
    StressNode node{.brick = brick, .cells = cells, .isFixed = isFixed, .isUsed = true};
    int64_t count = 0, weight = 0;
    glm::i64vec3 sum(0), weighted(0);
    forEachVoxel(cells, [&](int i) {
        const int64_t density = int64_t(entries[content.at(i)].density);
        const glm::i64vec3 twice(2 * voxelInBrick(i) + 1);
        ++count, weight += density, sum += twice, weighted += density * twice;
    });
    const glm::dvec3 base(brick * kBrickSize);
    node.center = base + glm::dvec3(sum) / double(2 * count);
    node.massCenter = weight ? base + glm::dvec3(weighted) / double(2 * weight) : node.center;
    node.weight = double(weight);
    m_nodes[index] = node;
    m_added.push_back(index);
}

void StressGraph::connect(const VoxelGrid& grid, const StrengthTable& entries, uint32_t below, uint32_t above, int axis,
                          int plane) {
    const uint64_t cells =
        brickLayer(m_nodes[below].cells, axis, plane - 1) & brickLayer(m_nodes[above].cells, axis, cellInBrick(plane));
    if (!cells) return;
    const uint32_t index = m_bondSlots.allocate();
    if (index == m_bonds.size()) m_bonds.emplace_back();
    StressBond bond{.below = below, .above = above, .section = {m_nodes[below].brick, axis, plane, cells}};
    bond.shape = sectionShape(bond.section);
    bond.strength = sectionStrength(grid, entries, bond.section, bond.canBreak);
    // A fixed node does not deform: on its side, the bond begins at the section.
    const double from = m_nodes[below].isFixed ? bond.shape.centroid[axis] : m_nodes[below].center[axis];
    const double to = m_nodes[above].isFixed ? bond.shape.centroid[axis] : m_nodes[above].center[axis];
    bond.length = std::max(0.5, to - from);
    m_bonds[index] = bond;
    for (const uint32_t end : {below, above}) {
        StressNode& node = m_nodes[end];
        (node.firstBond == kNoIndex ? node.firstBond : m_bonds[node.lastBond].nextOf(end)) = index;
        node.lastBond = index;
    }
}

void StressGraph::connectInside(const VoxelGrid& grid, const StrengthTable& entries, uint32_t a, uint32_t b) {
    if (m_nodes[a].isFixed && m_nodes[b].isFixed) return;
    for (int axis = 0; axis < 3; ++axis)
        for (int plane = 1; plane < 8; ++plane) {
            connect(grid, entries, a, b, axis, plane);
            connect(grid, entries, b, a, axis, plane);
        }
}

/// Lists the nodes that were added to a brick. Makes the bonds between them, and to those of its neighbours.
void StressGraph::connectBrick(const VoxelGrid& grid, const StrengthTable& entries, glm::ivec3 brick) {
    uint32_t* link = &m_firstNode[brickKey(brick)];
    for (const uint32_t node : m_added) *link = node, link = &m_nodes[node].nextInBrick;
    *link = kNoIndex;
    for (size_t i = 0; i < m_added.size(); ++i)
        for (size_t j = i + 1; j < m_added.size(); ++j) connectInside(grid, entries, m_added[i], m_added[j]);
    for (size_t face = 0; face < 6; ++face) {
        const uint32_t first = m_firstNode.find(brickKey(brick + kFaceOffsets[face]));
        for (const uint32_t mine : m_added)
            for (uint32_t other = first; other != kNoIndex; other = m_nodes[other].nextInBrick) {
                if (m_nodes[mine].isFixed && m_nodes[other].isFixed) continue;
                connect(grid, entries, face & 1 ? mine : other, face & 1 ? other : mine, int(face / 2), 8);
            }
    }
}

/// The displacement of the removed node that shares most cells with it, as a rigid body at the new centre.
void StressGraph::inheritDisplacement(StressNode& node) const {
    int mostShared = 0;
    for (const StressNode& from : m_removed) {
        int shared = 0;
        for (size_t z = 0; z < 8; ++z) shared += std::popcount(from.cells[z] & node.cells[z]);
        if (shared <= mostShared || node.isFixed) continue;
        mostShared = shared;
        node.translation = from.translation + glm::cross(from.rotation, node.center - from.center);
        node.rotation = from.rotation;
    }
}

}  // namespace rubble
