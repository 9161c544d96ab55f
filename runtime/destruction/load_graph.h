#pragma once
#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/destruction/load_section.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"

namespace rubble {

/// What a palette entry weighs and withstands. SI units.
struct LoadEntry {
    double density = 0.0, tensile = 0.0, compressive = 0.0, shear = 0.0;
    bool isSolid = false;   ///< carries; unphysical voxels do not
    bool canBreak = false;  ///< unbreakable ones carry whatever comes
};
using LoadEntries = std::array<LoadEntry, 256>;
LoadEntries loadEntries(const Palette& palette, const MaterialTable& materials);

/// A rigid part of a shape: a connected set of cells of one brick, without necks. Lengths in cells of the grid.
struct LoadNode {
    glm::ivec3 brick{0};
    BrickBits cells{};
    glm::dvec3 center{0.0};  ///< of its cells
    glm::dvec3 massCenter{0.0};
    double weight = 0.0;               ///< sum of densities
    bool isFixed = false;              ///< made of anchored cells: it never moves
    bool isUsed = false;               ///< or a free place in the list
    glm::dvec3 shift{0.0}, turn{0.0};  ///< how it gives way, from the last solution: the start of the next
    std::vector<uint32_t> bonds;
};

/// Two nodes hold to each other through the cell faces that they share: springs spread over the section.
struct LoadBond {
    uint32_t below = 0, above = 0;  ///< nodes, along the section's axis
    Section section;
    SectionShape shape;
    SectionStrength strength;  ///< Pa: the mean over its faces, each as weak as the weaker of its two cells
    double length = 1.0;       ///< between the nodes' centres, along the axis
    bool canBreak = true;
    bool isUsed = false;
};

/// A shape's parts and what holds them together: rigid bodies and springs (Kawai 1978). Changed a brick at a time.
class LoadGraph {
public:
    /// Makes the nodes and bonds of one brick anew from the grid, also after it lost all of its voxels.
    void setBrick(const VoxelGrid& grid, std::span<const CellBox> anchors, const LoadEntries& entries, glm::ivec3 brick);

    const std::vector<LoadNode>& nodes() const { return m_nodes; }
    const std::vector<LoadBond>& bonds() const { return m_bonds; }
    void setMotion(uint32_t node, glm::dvec3 shift, glm::dvec3 turn) { m_nodes[node].shift = shift, m_nodes[node].turn = turn; }

private:
    void addNode(const Brick& content, const LoadEntries& entries, glm::ivec3 brick, const BrickBits& cells, bool isFixed);
    void connectInside(const VoxelGrid& grid, const LoadEntries& entries, uint32_t a, uint32_t b);
    void connect(const VoxelGrid& grid, const LoadEntries& entries, uint32_t below, uint32_t above, int axis, int plane);
    void removeNode(uint32_t node);
    const std::vector<uint32_t>* nodesOf(glm::ivec3 brick) const;

    std::vector<LoadNode> m_nodes;
    std::vector<LoadBond> m_bonds;
    std::vector<uint32_t> m_freeNodes, m_freeBonds;
    std::unordered_map<uint32_t, std::vector<uint32_t>> m_bricks;  ///< nodes of a brick; looked up, never iterated
};

/// The cells of a brick that carry.
BrickBits solidCells(const Brick& brick, const LoadEntries& entries);
/// Which of a node's cells lie in anchors: bits of a brick.
BrickBits anchoredCells(glm::ivec3 brick, std::span<const CellBox> anchors);
/// Parts a connected set of cells where it is narrow inside: a neck is a body of its own on either side, so that it yields.
void splitAtNecks(const BrickBits& cells, std::vector<BrickBits>& out);

/// The strength of the cell faces of a section.
SectionStrength sectionStrength(const VoxelGrid& grid, const LoadEntries& entries, const Section& section, bool& canBreak);

}  // namespace rubble
