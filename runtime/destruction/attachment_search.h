#pragma once
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "runtime/destruction/brick_set.h"
#include "runtime/destruction/components.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

/// Whether a component of a grid has a cell in one of the boxes.
bool touchesAnchor(const VoxelGrid& grid, const Component& component, std::span<const CellBox> anchors);

/// Grows a set of voxels from everything that the carved bricks' neighbours hold, a part of a directory node (see
/// NodeParts) at a time, all sets in turns, and joins those that meet. A set is done when nothing is left to grow into,
/// or when it has reached an anchor. A value: it may rest and go on later, on the same grid, as long as no voxel comes
/// or goes.
class AttachmentSearch {
public:
    AttachmentSearch(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored, const BrickSet& carved);

    /// Grows until each set is done or is known to be what all the others came off; false if `budget` parts were not
    /// enough. Takes from the budget what was used.
    bool run(const VoxelGrid& grid, std::span<const CellBox> anchors, size_t& budget);
    /// Parts visitedParts so far.
    size_t visitedParts() const { return m_parts.size(); }
    /// Whether a set stopped before it could grow no further: it is what stays.
    bool hasUnfinished() const { return !m_open.empty(); }
    /// The sets that could grow no further and hold no anchor, ordered by their lowest cell.
    std::vector<Component> finished(const VoxelGrid& grid);

private:
    static constexpr uint32_t kNone = ~0u;
    struct Part {
        glm::ivec3 node;
        uint32_t component = 0;  ///< of the node's parts
        uint32_t set = kNone;
    };
    struct Frontier {
        int distance;  ///< from the nearest anchor, in cells along the axes
        uint32_t part;
        friend auto operator<=>(const Frontier&, const Frontier&) = default;
    };
    struct Set {
        uint32_t parent;
        bool isAnchored = false;
        bool isFinished = false;
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

    std::unordered_map<uint32_t, uint32_t> m_nodes;  ///< a node's first part; looked up, never iterated
    std::vector<Part> m_parts;
    std::vector<Set> m_sets;
    std::vector<uint32_t> m_open;  ///< sets that may still grow
    size_t m_turn = 0;             ///< whose turn in m_open it is
    uint64_t m_finishedVoxels = 0, m_largestFinished = 0;
    bool m_isAnchored = false;     ///< whether anchors decide what stays
    bool m_anchorsCarved = false;  ///< by the cut
    bool m_anchorFound = false;
};

}  // namespace rubble
