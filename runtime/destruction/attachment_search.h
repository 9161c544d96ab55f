#pragma once
#include <span>
#include <unordered_map>
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

/// Whether a share has a cell in one of the boxes.
bool touchesAnchor(const BrickShare& share, std::span<const CellBox> anchors);

/// Grows a set of voxels from every part of the carved bricks and their neighbours, all of them in turns, and joins those
/// that meet. A set is done when nothing is left to grow into, or when it has reached an anchor.
class AttachmentSearch {
public:
    AttachmentSearch(const VoxelGrid& grid, std::span<const CellBox> anchors, std::span<const glm::ivec3> carved);

    /// Grows until each set is done or is known to be what all the others came off; false if that takes more than `budget` parts.
    bool run(bool isAnchored, size_t budget);
    /// Whether a set stopped before it could grow no further: it is what stays.
    bool hasOpen() const { return !m_open.empty(); }
    /// The sets that could grow no further and hold no anchor, ordered by their lowest cell.
    std::vector<Component> takeFinished();

private:
    static constexpr uint32_t kNone = ~0u;
    struct Part {
        BrickPart cells;
        glm::ivec3 brick;
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
        uint64_t voxels = 0;
        std::vector<uint32_t> parts;
        std::vector<Frontier> frontier;  ///< a heap, nearest first
    };
    struct Range {
        uint32_t first = 0, end = 0;
    };

    Range partsOf(glm::ivec3 brick);
    uint32_t root(uint32_t set);
    void addPart(uint32_t set, uint32_t part);
    void join(uint32_t a, uint32_t b);
    void grow(uint32_t set);
    void visitNeighbour(uint32_t part, size_t face);
    int anchorDistance(glm::ivec3 brick) const;
    bool isOpen(uint32_t set) const;
    bool isSettled(bool isAnchored);

    const VoxelGrid& m_grid;
    std::span<const CellBox> m_anchors;
    std::unordered_map<uint32_t, Range> m_bricks;  ///< looked up, never iterated
    std::vector<Part> m_parts;
    std::vector<Set> m_sets;
    std::vector<uint32_t> m_open;  ///< sets that may still grow
    bool m_anchorsTouched = false;
    std::vector<BrickPart> m_scratch;
};

}  // namespace rubble
