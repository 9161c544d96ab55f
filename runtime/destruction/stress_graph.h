#pragma once
#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/destruction/cross_section.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"

namespace rubble {

/// What a palette entry weighs and withstands. SI units.
struct EntryStrength {
    double density = 0.0, tensile = 0.0, compressive = 0.0, shear = 0.0;
    bool isSolid = false;   ///< carries; unphysical voxels do not
    bool canBreak = false;  ///< unbreakable ones carry whatever comes
};
using StrengthTable = std::array<EntryStrength, 256>;
StrengthTable makeStrengthTable(const Palette& palette, const MaterialTable& materials);

/// A rigid part of a shape: a connected set of cells of one brick, without necks. Lengths in cells of the grid.
struct StressNode {
    glm::ivec3 brick{0};
    BrickBits cells{};
    glm::dvec3 center{0.0};  ///< of its cells
    glm::dvec3 massCenter{0.0};
    double weight = 0.0;                         ///< sum of densities
    bool isFixed = false;                        ///< made of anchored cells: it never moves
    bool isUsed = false;                         ///< or a free place in the list
    glm::dvec3 translation{0.0}, rotation{0.0};  ///< how it gives way, from the last solution: the start of the next
    std::vector<uint32_t> bonds;
};

/// Two nodes hold to each other through the cell faces that they ratio: springs spread over the section.
struct StressBond {
    uint32_t below = 0, above = 0;  ///< nodes, along the section's axis
    Section section;
    SectionShape shape;
    SectionStrength strength;  ///< Pa: the mean over its faces, each as weak as the weaker of its two cells
    double length = 1.0;       ///< between the nodes' centres, along the axis
    bool canBreak = true;
    bool isUsed = false;
};

/// A shape's parts and what holds them together: rigid bodies and springs (Kawai 1978). Changed a brick at a time.
class StressGraph {
public:
    /// Makes the nodes and bonds of one brick anew from the grid, also after it lost all of its voxels.
    void setBrick(const VoxelGrid& grid, std::span<const CellBox> anchors, const StrengthTable& entries,
                  glm::ivec3 brick);

    const std::vector<StressNode>& nodes() const { return m_nodes; }
    const std::vector<StressBond>& bonds() const { return m_bonds; }
    void setDisplacement(uint32_t node, glm::dvec3 translation, glm::dvec3 rotation) {
        m_nodes[node].translation = translation, m_nodes[node].rotation = rotation;
    }

private:
    void addNode(const Brick& content, const StrengthTable& entries, glm::ivec3 brick, const BrickBits& cells,
                 bool isFixed);
    void connectInside(const VoxelGrid& grid, const StrengthTable& entries, uint32_t a, uint32_t b);
    void connect(const VoxelGrid& grid, const StrengthTable& entries, uint32_t below, uint32_t above, int axis,
                 int plane);
    void removeNode(uint32_t node);
    const std::vector<uint32_t>* nodesOf(glm::ivec3 brick) const;

    std::vector<StressNode> m_nodes;
    std::vector<StressBond> m_bonds;
    std::vector<uint32_t> m_freeNodes, m_freeBonds;
    std::unordered_map<uint32_t, std::vector<uint32_t>> m_bricks;  ///< nodes of a brick; looked up, never iterated
};

/// The cells of a brick that carry.
BrickBits solidCells(const Brick& brick, const StrengthTable& entries);
/// Which of a node's cells lie in anchors: bits of a brick.
BrickBits anchoredCells(glm::ivec3 brick, std::span<const CellBox> anchors);
/// Parts a connected set of cells where it is narrow inside: a neck is a body of its own on either side, so that it
/// yields.
void splitAtNecks(const BrickBits& cells, std::vector<BrickBits>& out);

/// The strength of the cell faces of a section.
SectionStrength sectionStrength(const VoxelGrid& grid, const StrengthTable& entries, const Section& section,
                                bool& canBreak);

}  // namespace rubble
