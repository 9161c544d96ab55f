#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "runtime/core/world_box.h"

namespace rubble {

/// Boxes that are searched often before they change: a tree with eight boxes a node that is built as a whole, in the
/// time of sorting them. See packed_boxes.cpp. [one thread]
class PackedBoxes {
public:
    /// Replaces all boxes (metres). They are kept as floats from `origin`.
    void build(std::span<const WorldBox> boxes, const glm::dvec3& origin);
    /// Appends the indices of all pairs of boxes that overlap, and of some that miss each other by the rounding of a
    /// float; each pair once, in no particular order.
    void findPairs(std::vector<std::pair<uint32_t, uint32_t>>& out) const;

private:
    static constexpr uint32_t kWidth = 8;
    using Row = std::array<float, kWidth>;
    /// Eight boxes; those that are not used overlap nothing.
    struct Node {
        std::array<Row, 3> low, high;  ///< by axis
    };
    struct Box {
        glm::vec3 low, high;
    };
    void addLevel(size_t children);
    static uint32_t overlaps(const Node& node, const Box& box);
    void findLeaves(const Box& box, uint32_t from, std::vector<uint32_t>& out) const;

    glm::dvec3 m_origin{0.0};
    std::vector<std::pair<uint64_t, uint32_t>> m_order;  ///< place on the curve and index, sorted
    std::vector<Node> m_nodes;                           ///< level after level, from the boxes up to the root
    std::vector<uint32_t> m_levels;                      ///< the first node of each level
};

}  // namespace rubble
