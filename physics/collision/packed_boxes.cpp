#include "physics/collision/packed_boxes.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "physics/math/simd4.h"

// A tree of boxes without pointers: the boxes are sorted along a curve that fills space (Morton's, of 2^21 places along
// each axis of the box of all middles), every eight in a row are a leaf, and every eight nodes in a row have a parent
// (after Lauterbach et al., "Fast BVH Construction on GPUs", Eurographics 2009, with ranges of equal length). Eight
// boxes are compared at once. What moves is built again in every step, so that no motion makes the tree worse.

namespace rubble {
namespace {

constexpr double kPlaces = 1 << 21;  ///< along an axis of the curve
constexpr float kNowhere = std::numeric_limits<float>::max();

/// Moves bit i of the lowest 21 to bit 3 i.
uint64_t spread(uint64_t v) {
    v = (v | v << 32) & 0x001f00000000ffff;
    v = (v | v << 16) & 0x001f0000ff0000ff;
    v = (v | v << 8) & 0x100f00f00f00f00f;
    v = (v | v << 4) & 0x10c30c30c30c30c3;
    return (v | v << 2) & 0x1249249249249249;
}

}  // namespace

void PackedBoxes::build(std::span<const WorldBox> boxes, const glm::dvec3& origin) {
    m_origin = origin;
    m_nodes.clear();
    m_levels.assign(1, 0);
    m_order.clear();
    WorldBox middles{glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (const WorldBox& box : boxes) {
        const glm::dvec3 middle = (box.low + box.high) * 0.5;
        middles = {glm::min(middles.low, middle), glm::max(middles.high, middle)};
    }
    const glm::dvec3 scale = (kPlaces - 1.0) / glm::max(middles.high - middles.low, 1e-9);
    for (uint32_t i = 0; i < boxes.size(); ++i) {
        const glm::dvec3 at = ((boxes[i].low + boxes[i].high) * 0.5 - middles.low) * scale;
        m_order.emplace_back(spread(uint64_t(at.x)) | spread(uint64_t(at.y)) << 1 | spread(uint64_t(at.z)) << 2, i);
    }
    std::sort(m_order.begin(), m_order.end());
    addLevel(boxes.size());
    for (size_t i = 0; i < boxes.size(); ++i) {
        const WorldBox& box = boxes[m_order[i].second];
        const glm::vec3 low(box.low - m_origin), high(box.high - m_origin);
        for (size_t axis = 0; axis < 3; ++axis) {
            m_nodes[i / kWidth].low[axis][i % kWidth] = low[int(axis)];
            m_nodes[i / kWidth].high[axis][i % kWidth] = high[int(axis)];
        }
    }
    for (size_t from = 0; m_nodes.size() - from > 1;) {
        const size_t count = m_nodes.size() - from, parents = m_nodes.size();
        m_levels.push_back(uint32_t(parents));
        addLevel(count);
        for (size_t i = 0; i < count; ++i)
            for (size_t axis = 0; axis < 3; ++axis) {
                const Row &low = m_nodes[from + i].low[axis], &high = m_nodes[from + i].high[axis];
                m_nodes[parents + i / kWidth].low[axis][i % kWidth] = *std::min_element(low.begin(), low.end());
                m_nodes[parents + i / kWidth].high[axis][i % kWidth] = *std::max_element(high.begin(), high.end());
            }
        from = parents;
    }
}

/// Appends nodes for this many boxes, without any.
void PackedBoxes::addLevel(size_t children) {
    Node empty;
    for (size_t axis = 0; axis < 3; ++axis) empty.low[axis].fill(kNowhere), empty.high[axis].fill(-kNowhere);
    m_nodes.insert(m_nodes.end(), (children + kWidth - 1) / kWidth, empty);
}

/// Bit i: the i-th box of a node overlaps the box.
uint32_t PackedBoxes::overlaps(const Node& node, const Box& box) {
    uint32_t bits = 0;
    for (uint32_t half = 0; half < kWidth; half += 4) {
        Bool4 overlap{-1, -1, -1, -1};
        for (int axis = 0; axis < 3; ++axis)
            overlap &= (load(node.low[size_t(axis)].data() + half) <= float4(box.high[axis])) &
                       (load(node.high[size_t(axis)].data() + half) >= float4(box.low[axis]));
        bits |= bitsOf(overlap) << half;
    }
    return bits;
}

/// Appends the leaves from the number `from` on that may hold what overlaps the box.
void PackedBoxes::findLeaves(const Box& box, uint32_t from, std::vector<uint32_t>& out) const {
    struct Visit {
        uint32_t level, node;  ///< counted from the first of its level
    };
    std::array<Visit, kWidth * 32 / 3> open;  // a level multiplies by 8, and indices have 32 bits
    size_t count = 0;
    open[count++] = {uint32_t(m_levels.size() - 1), 0};
    while (count) {
        const Visit visit = open[--count];
        if (visit.level == 0) {
            out.push_back(visit.node);
            continue;
        }
        const uint32_t first = from >> 3 * (visit.level - 1);  // of the level below, above `from`
        for (uint32_t hits = overlaps(m_nodes[m_levels[visit.level] + visit.node], box); hits; hits &= hits - 1) {
            const uint32_t child = visit.node * kWidth + uint32_t(std::countr_zero(hits));
            if (child >= first) open[count++] = {visit.level - 1, child};
        }
    }
}

/// Leaf by leaf: what overlaps any of its eight boxes is found once for all of them.
void PackedBoxes::findPairs(std::vector<std::pair<uint32_t, uint32_t>>& out) const {
    const uint32_t count = uint32_t(m_order.size());
    std::vector<uint32_t> near;
    near.reserve(64);
    for (uint32_t leaf = 0; leaf * kWidth < count; ++leaf) {
        const Node& own = m_nodes[leaf];
        Box all{glm::vec3(kNowhere), glm::vec3(-kNowhere)};
        for (size_t axis = 0; axis < 3; ++axis) {
            all.low[int(axis)] = *std::min_element(own.low[axis].begin(), own.low[axis].end());
            all.high[int(axis)] = *std::max_element(own.high[axis].begin(), own.high[axis].end());
        }
        near.clear();
        findLeaves(all, leaf, near);
        for (uint32_t i = 0; i < std::min(kWidth, count - leaf * kWidth); ++i) {
            const Box box{{own.low[0][i], own.low[1][i], own.low[2][i]},
                          {own.high[0][i], own.high[1][i], own.high[2][i]}};
            const uint32_t first = m_order[leaf * kWidth + i].second;
            for (const uint32_t other : near) {
                uint32_t hits = overlaps(m_nodes[other], box);
                if (other == leaf) hits &= ~0u << i << 1;
                for (; hits; hits &= hits - 1)
                    out.emplace_back(first, m_order[other * kWidth + uint32_t(std::countr_zero(hits))].second);
            }
        }
    }
}

}  // namespace rubble
