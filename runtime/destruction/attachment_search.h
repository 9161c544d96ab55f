#pragma once
#include <optional>
#include <span>
#include <vector>

#include "runtime/core/index_map.h"
#include "runtime/destruction/brick_set.h"
#include "runtime/destruction/components.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

/// Whether a component of a grid has a cell in one of the boxes.
bool touchesAnchor(const VoxelGrid& grid, const Component& component, std::span<const CellBox> anchors);

/// Finds which parts of a grid a cut has detached, by search from the cut outward; the algorithm is at the top of
/// attachment_search.cpp. A value: it may be copied, and go on later on the same grid as long as no voxel changes.
class AttachmentSearch {
public:
    /// Starts at the bricks `carved`, which have lost voxels. Nothing may have been detached before that cut.
    /// isAnchored: whether anchors decide what stays; else the largest component does.
    AttachmentSearch(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored, const BrickSet& carved);

    /// Goes on with the grid and the anchors of the constructor. `budget`: parts it may expand; what it used is
    /// subtracted. Returns true when the result is known, false if the budget was not enough.
    bool run(const VoxelGrid& grid, std::span<const CellBox> anchors, size_t& budget);
    /// Parts (components of nodes) seen so far.
    size_t visitedParts() const { return m_parts.size(); }
    /// Whether one set stopped early, because it must be what stays.
    bool hasUnfinished() const { return !m_open.empty(); }
    /// The sets that are whole components without an anchor, ordered by their lowest cell. After run() has returned
    /// true.
    std::vector<Component> finished(const VoxelGrid& grid);

private:
    static constexpr uint32_t kNone = ~0u;
    /// A component of one node (see NodeParts): the unit that sets grow by.
    struct Part {
        glm::ivec3 node;
        uint32_t component = 0;  ///< its number in the node
        uint32_t set = kNone;
    };
    /// A part of a set whose neighbours have not been visited.
    struct Frontier {
        int distance;  ///< from its node to the nearest anchor, in cells along the axes
        uint32_t part;
        friend auto operator<=>(const Frontier&, const Frontier&) = default;
    };
    /// Connected parts. Sets that meet are united (union-find).
    struct Set {
        uint32_t parent;
        bool isAnchored = false;  ///< one of its cells lies in an anchor
        bool isFinished = false;  ///< a whole component without an anchor
        uint64_t voxels = 0;
        std::vector<uint32_t> parts;
        std::vector<Frontier> frontier;  ///< a heap, nearest first
    };
    struct View {
        const VoxelGrid& grid;
        std::span<const CellBox> anchors;
    };

    void seed(const View& view, glm::ivec3 position, BrickMask carved, const BrickSet& all);
    std::optional<uint32_t> firstPartOf(const View& view, glm::ivec3 position);
    uint32_t root(uint32_t set);
    void addPart(const View& view, uint32_t set, uint32_t part);
    void join(uint32_t a, uint32_t b);
    void grow(const View& view, uint32_t set);
    void visitNeighbour(const View& view, uint32_t part, size_t face, bool onlyKnown);
    bool isOpen(uint32_t set) const;
    void updateSetState(uint32_t set);
    bool isDecided(const View& view) const;

    IndexMap m_nodes;  ///< a node's first part
    std::vector<Part> m_parts;
    std::vector<Set> m_sets;
    std::vector<uint32_t> m_open;    ///< sets that may still grow
    size_t m_turn = 0;               ///< index in m_open of the set that grows next
    uint64_t m_finishedVoxels = 0;   ///< of all finished sets
    uint64_t m_largestFinished = 0;  ///< voxels of the largest finished set
    bool m_isAnchored = false;       ///< whether anchors decide what stays
    bool m_anchorsCarved = false;    ///< whether a carved brick reaches into an anchor
    bool m_anchorFound = false;      ///< whether a set is anchored
};

}  // namespace rubble
