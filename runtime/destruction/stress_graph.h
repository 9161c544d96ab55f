#pragma once
#include <array>
#include <span>
#include <vector>

#include "runtime/core/index_allocator.h"
#include "runtime/core/index_map.h"
#include "runtime/destruction/components.h"
#include "runtime/destruction/cross_section.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"

namespace rubble {

/// The density and strength of a palette entry. SI units.
struct EntryStrength {
    double density = 0.0;                                  ///< kg/m3
    double tensile = 0.0, compressive = 0.0, shear = 0.0;  ///< Pa
    bool isSolid = false;                                  ///< load-bearing; unphysical voxels are not
    bool canBreak = false;                                 ///< unbreakable ones never do
};
using StrengthTable = std::array<EntryStrength, 256>;  ///< by palette entry
/// The strengths of the materials of a palette.
StrengthTable makeStrengthTable(const Palette& palette, const MaterialTable& materials);

inline constexpr uint32_t kNoIndex = IndexMap::kNone;  ///< of no node or bond

/// A rigid part of a shape: connected cells of one brick without a neck between them. Lengths in cells of the grid.
struct StressNode {
    glm::ivec3 brick{0};
    BrickBits cells{};
    glm::dvec3 center{0.0};                      ///< of its cells
    glm::dvec3 massCenter{0.0};                  ///< centre of mass
    double weight = 0.0;                         ///< sum of densities
    bool isFixed = false;                        ///< made of anchored cells: it never moves
    bool isUsed = false;                         ///< false: a free slot of the list
    glm::dvec3 translation{0.0}, rotation{0.0};  ///< displacement of the last solution: the next one starts from it
    uint32_t firstBond = kNoIndex, lastBond = kNoIndex;  ///< the list of its bonds: StressBond::nextOf()
    uint32_t nextInBrick = kNoIndex;                     ///< the next node of the same brick
};

/// A connection of two nodes through the cell faces they share: springs spread over the section.
struct StressBond {
    uint32_t below = 0, above = 0;  ///< the nodes on either side of the section, along its axis
    Section section;
    SectionShape shape;
    SectionStrength strength;  ///< Pa: the mean over its faces; a face has the strength of its weaker cell
    double length = 1.0;       ///< between the nodes' centres along the axis, in cells
    bool canBreak = true;
    uint32_t nextOfBelow = kNoIndex, nextOfAbove = kNoIndex;  ///< the next bond of each of its nodes

    /// The other one of its nodes.
    uint32_t other(uint32_t node) const { return node == below ? above : below; }
    /// The next bond in the list of one of its nodes.
    uint32_t nextOf(uint32_t node) const { return node == below ? nextOfBelow : nextOfAbove; }
    /// The next bond in the list of one of its nodes.
    uint32_t& nextOf(uint32_t node) { return node == below ? nextOfBelow : nextOfAbove; }
};

/// The rigid parts of a shape and the bonds between them: a rigid bodies-spring model (T. Kawai, "New discrete models
/// and their application to seismic response analysis of structures", Nuclear Engineering and Design 48, 1978). Updated
/// brick by brick. All of it lies in a few arrays with lists linked through them: slots of removed nodes and bonds are
/// used again, so indices stay valid, and a change of a brick takes no memory.
class StressGraph {
public:
    /// Rebuilds the nodes and bonds of one brick from the grid, also after it lost all of its voxels. New nodes take
    /// over the displacement of the old node that they share most cells with.
    void setBrick(const VoxelGrid& grid, std::span<const CellBox> anchors, const StrengthTable& entries,
                  glm::ivec3 brick);

    /// All slots of nodes; see StressNode::isUsed.
    const std::vector<StressNode>& nodes() const { return m_nodes; }
    /// Calls f(const StressBond&, uint32_t other) for each bond of a node, with the node at its other end.
    template <class F>
    void forEachBond(uint32_t node, F&& f) const {
        for (uint32_t bond = m_nodes[node].firstBond; bond != kNoIndex; bond = m_bonds[bond].nextOf(node))
            f(m_bonds[bond], m_bonds[bond].other(node));
    }
    /// Stores the solution for a node. translation: of its centre.
    void setDisplacement(uint32_t node, glm::dvec3 translation, glm::dvec3 rotation) {
        m_nodes[node].translation = translation, m_nodes[node].rotation = rotation;
    }

private:
    void removeNodes(glm::ivec3 brick);
    void removeBond(uint32_t bond);
    void addNodes(const Brick& content, std::span<const CellBox> anchors, const StrengthTable& entries,
                  glm::ivec3 brick);
    void addNode(const Brick& content, const StrengthTable& entries, glm::ivec3 brick, const BrickBits& cells,
                 bool isFixed);
    void splitAtNecks(const BrickBits& cells);
    void connectBrick(const VoxelGrid& grid, const StrengthTable& entries, glm::ivec3 brick);
    void inheritDisplacement(StressNode& node) const;
    void connectInside(const VoxelGrid& grid, const StrengthTable& entries, uint32_t a, uint32_t b);
    void connect(const VoxelGrid& grid, const StrengthTable& entries, uint32_t below, uint32_t above, int axis,
                 int plane);

    std::vector<StressNode> m_nodes;
    std::vector<StressBond> m_bonds;
    IndexAllocator m_nodeSlots, m_bondSlots;
    IndexMap m_firstNode;  ///< by brickKey()
    // Of setBrick():
    std::vector<StressNode> m_removed;
    std::vector<uint32_t> m_added;
    std::vector<BrickPart> m_parts;
    std::vector<BrickBits> m_bodies;
};

/// The load-bearing cells of a brick.
BrickBits solidCells(const Brick& brick, const StrengthTable& entries);
/// The cells of a brick that lie in an anchor.
BrickBits anchoredCells(glm::ivec3 brick, std::span<const CellBox> anchors);
/// The mean strength of the cell faces of a section, in Pa. canBreak: whether one of its cells can break.
SectionStrength sectionStrength(const VoxelGrid& grid, const StrengthTable& entries, const Section& section,
                                bool& canBreak);

}  // namespace rubble
