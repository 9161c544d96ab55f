#include "runtime/destruction/attachment_search.h"

#include <algorithm>
#include <glm/common.hpp>

#include "runtime/destruction/local_connectivity.h"
#include "runtime/voxel/brick_box.h"

// Which parts does a cut detach? Incremental connectivity by search from the cut.
//
// Before the cut, every voxel was connected to what stays. Whatever the cut detached therefore borders on it. One set
// of voxels grows from each component around the carved bricks, all sets in turns, by one part (component of a
// directory node) at a time, so that a set costs at most about as much as the smallest ones: searching the two sides of
// a cut in parallel costs only the smaller side (S. Even and Y. Shiloach, "An on-line edge-deletion problem", JACM 28,
// 1981). Sets that meet are united (union-find). A set that reaches an anchor stays; a set that cannot grow any more
// and has no anchor is detached. Parts near anchors grow first, so most sets are decided early. The search ends when at
// most one set is undecided and it must be what stays: because no other set can hold the anchors, or because it has
// more voxels left than the largest detached one.

namespace rubble {
namespace {

/// A number for each node of a grid. A position one outside of the grid gets a number that no node has.
uint32_t nodeKey(glm::ivec3 node) {
    static_assert(kMaxGridSize / kNodeSize <= 512, "nine bits an axis, and one that stays clear");
    return uint32_t(node.x) | uint32_t(node.y) << 10 | uint32_t(node.z) << 20;
}

/// Whether a box overlaps the cube of cells [low, low + size).
bool meets(const CellBox& box, glm::ivec3 low, int size) {
    return glm::all(glm::lessThan(box.low, low + size)) && glm::all(glm::greaterThan(box.high, low)) && !box.empty();
}

bool nodeMeets(glm::ivec3 node, std::span<const CellBox> anchors) {
    return std::any_of(anchors.begin(), anchors.end(),
                       [&](const CellBox& box) { return meets(box, node * kNodeSize, kNodeSize); });
}

/// Whether some of a brick's voxels lie in one of the boxes.
bool holds(glm::ivec3 brick, const BrickBits& voxels, std::span<const CellBox> anchors) {
    for (const CellBox& anchor : anchors) {
        const BrickBits inside = cellsInBox(brick, anchor);
        for (size_t z = 0; z < 8; ++z)
            if (voxels[z] & inside[z]) return true;
    }
    return false;
}

/// Whether a component of the node has a cell in one of the boxes.
bool partTouches(const BrickNode& node, glm::ivec3 position, uint32_t part, std::span<const CellBox> anchors) {
    if (!nodeMeets(position, anchors)) return false;
    const NodeParts& parts = nodeParts(node);
    std::vector<BrickPart> scratch;
    for (BrickMask left = node.mask; left; left &= left - 1) {
        const int child = std::countr_zero(left);
        const glm::ivec3 brick = position * kNodeBricks + childPosition(child);
        if (!holds(brick, node.bricks[size_t(child)]->occupancy, anchors)) continue;
        if (parts.count == 1) return true;
        const auto cells = brickParts(*node.bricks[size_t(child)], scratch);
        for (size_t i = 0; i < cells.size(); ++i)
            if (parts.componentOf(child, i) == part && holds(brick, cells[i].voxels, anchors)) return true;
    }
    return false;
}

/// From the middle of a node to the nearest box, in cells along the axes; 0 if there is none.
int anchorDistance(glm::ivec3 node, std::span<const CellBox> anchors) {
    int nearest = anchors.empty() ? 0 : INT32_MAX;
    const glm::ivec3 middle = node * kNodeSize + kNodeSize / 2;
    for (const CellBox& box : anchors) {
        const glm::ivec3 away = glm::max(glm::max(box.low - middle, middle - box.high), 0);
        nearest = std::min(nearest, away.x + away.y + away.z);
    }
    return nearest;
}

/// The bricks of a node that touch one of `bricks`, which lie in the neighbouring node beyond `face`.
BrickMask facingBricks(BrickMask bricks, size_t face) {
    const int shift = kNeighborShift[face];
    return shift > 0 ? (bricks & kFaceBricks[face ^ 1]) >> shift : (bricks & kFaceBricks[face ^ 1]) << -shift;
}

/// The bricks of a node beyond `face` of the given ones, in the same node.
BrickMask stepped(BrickMask bricks, size_t face) {
    constexpr std::array<int, 3> kSteps = {1, 4, 16};
    const BrickMask inside = bricks & ~kFaceBricks[face];
    return face & 1 ? inside << kSteps[face / 2] : inside >> kSteps[face / 2];
}

}  // namespace

bool touchesAnchor(const VoxelGrid& grid, const Component& component, std::span<const CellBox> anchors) {
    for (const BrickSubset& subset : component.subsets)
        if (holds(subset.brick, subset.voxels, anchors)) return true;
    for (const NodeSubset& subset : component.nodes) {
        if (!nodeMeets(subset.node, anchors)) continue;
        const BrickNode& node = *grid.nodeAt(subset.node);
        for (BrickMask left = subset.bricks; left; left &= left - 1) {
            const int child = std::countr_zero(left);
            if (holds(subset.node * kNodeBricks + childPosition(child), node.bricks[size_t(child)]->occupancy, anchors))
                return true;
        }
    }
    return false;
}

AttachmentSearch::AttachmentSearch(const VoxelGrid& grid, std::span<const CellBox> anchors, bool isAnchored,
                                   const BrickSet& carved)
    : m_isAnchored(isAnchored) {
    const View view{grid, isAnchored ? anchors : std::span<const CellBox>{}};
    BrickSet nodes;  // that hold a carved brick or a neighbour of one
    carved.forEachNode([&](glm::ivec3 node, BrickMask bricks) {
        nodes.insert(node, bricks);
        for (size_t face = 0; face < 6; ++face)
            if (bricks & kFaceBricks[face]) nodes.insert(node + kFaceOffsets[face], 0);
        if (m_anchorsCarved || !nodeMeets(node, view.anchors)) return;
        forEachChild(bricks, [&](int child) {
            m_anchorsCarved =
                m_anchorsCarved || holds(node * kNodeBricks + childPosition(child), kFullBrickBits, view.anchors);
        });
    });
    if (!m_anchorsCarved && isLocallyConnected(grid, carved)) return;
    nodes.forEachNode([&](glm::ivec3 node, BrickMask bricks) { seed(view, node, bricks, carved); });
    // Seeds that touch are united before anything grows.
    const uint32_t seedParts = uint32_t(m_parts.size());
    for (uint32_t part = 0; part < seedParts; ++part)
        for (size_t face = 1; face < 6; face += 2)
            if (m_parts[part].set != kNone) visitNeighbour(view, part, face, true);
    for (uint32_t set = 0; set < m_sets.size(); ++set)
        if (root(set) == set) updateSetState(set);
}

/// Starts a set for each part of the node that may have touched a removed voxel.
void AttachmentSearch::seed(const View& view, glm::ivec3 position, BrickMask carved, const BrickSet& all) {
    const std::optional<uint32_t> first = firstPartOf(view, position);
    if (!first) return;
    const BrickNode& node = *view.grid.nodeAt(position);
    const NodeParts& parts = nodeParts(node);
    const auto start = [&](uint32_t component) {
        if (m_parts[*first + component].set != kNone) return;
        m_sets.push_back({.parent = uint32_t(m_sets.size())});
        addPart(view, uint32_t(m_sets.size() - 1), *first + component);
    };
    std::array<BrickMask, 6> beside;  // by face: bricks with a carved brick beyond it
    BrickMask near = carved;
    for (size_t face = 0; face < 6; ++face) {
        beside[face] = stepped(carved, face ^ 1) | facingBricks(all.at(position + kFaceOffsets[face]), face);
        near |= beside[face];
    }
    near &= node.mask;
    if (parts.count == 1) {
        if (near) start(0);
        return;
    }
    std::vector<BrickPart> scratch;
    forEachChild(near, [&](int child) {
        const auto cells = brickParts(*node.bricks[size_t(child)], scratch);
        for (size_t i = 0; i < cells.size(); ++i) {
            bool touches = carved >> child & 1;
            for (size_t face = 0; face < 6; ++face)
                touches = touches || ((beside[face] >> child & 1) && cells[i].faces[face]);
            if (touches) start(parts.componentOf(child, i));
        }
    });
}

std::optional<uint32_t> AttachmentSearch::firstPartOf(const View& view, glm::ivec3 position) {
    const BrickNode* node = view.grid.nodeAt(position);
    if (!node) return std::nullopt;
    uint32_t& first = m_nodes[nodeKey(position)];
    if (first == kNone) {
        first = uint32_t(m_parts.size());
        for (uint32_t i = 0; i < nodeParts(*node).count; ++i) m_parts.push_back({position, i, kNone});
    }
    return first;
}

uint32_t AttachmentSearch::root(uint32_t set) {
    while (m_sets[set].parent != set) set = m_sets[set].parent = m_sets[m_sets[set].parent].parent;
    return set;
}

void AttachmentSearch::addPart(const View& view, uint32_t set, uint32_t index) {
    Part& part = m_parts[index];
    Set& into = m_sets[set];
    const BrickNode& node = *view.grid.nodeAt(part.node);
    part.set = set;
    into.voxels += nodeParts(node).voxels[part.component];
    into.isAnchored = into.isAnchored || partTouches(node, part.node, part.component, view.anchors);
    m_anchorFound = m_anchorFound || into.isAnchored;
    into.parts.push_back(index);
    into.frontier.push_back({anchorDistance(part.node, view.anchors), index});
    std::push_heap(into.frontier.begin(), into.frontier.end(), std::greater<>());
}

void AttachmentSearch::join(uint32_t a, uint32_t b) {
    a = root(a), b = root(b);
    if (a == b) return;
    if (m_sets[a].parts.size() < m_sets[b].parts.size()) std::swap(a, b);
    Set &into = m_sets[a], &from = m_sets[b];
    from.parent = a;
    into.isAnchored = into.isAnchored || from.isAnchored;
    into.voxels += from.voxels;
    into.parts.insert(into.parts.end(), from.parts.begin(), from.parts.end());
    for (const Frontier& each : from.frontier) {
        into.frontier.push_back(each);
        std::push_heap(into.frontier.begin(), into.frontier.end(), std::greater<>());
    }
    from.parts = {};
    from.frontier = {};
}

/// Unites a part with those it touches beyond a face. `onlyKnown`: only with parts that are in a set already.
void AttachmentSearch::visitNeighbour(const View& view, uint32_t index, size_t face, bool onlyKnown) {
    const Part part = m_parts[index];
    const glm::ivec3 position = part.node + kFaceOffsets[face];
    if (onlyKnown && m_nodes.find(nodeKey(position)) == kNone) return;
    const std::optional<uint32_t> first = firstPartOf(view, position);
    if (!first) return;
    forEachContact(*view.grid.nodeAt(part.node), *view.grid.nodeAt(position), face,
                   [&](uint16_t mine, uint16_t theirs) {
                       if (mine != part.component) return true;
                       const uint32_t other = *first + theirs, set = root(part.set);
                       if (m_parts[other].set != kNone)
                           join(set, m_parts[other].set);
                       else if (!onlyKnown)
                           addPart(view, set, other);
                       return true;
                   });
}

void AttachmentSearch::grow(const View& view, uint32_t set) {
    std::vector<Frontier>& frontier = m_sets[set].frontier;
    std::pop_heap(frontier.begin(), frontier.end(), std::greater<>());
    const uint32_t part = frontier.back().part;
    frontier.pop_back();
    for (size_t face = 0; face < 6; ++face) visitNeighbour(view, part, face, false);
}

bool AttachmentSearch::isOpen(uint32_t set) const {
    return m_sets[set].parent == set && !m_sets[set].isAnchored && !m_sets[set].frontier.empty();
}

/// Lists a set as open if it can grow; counts it as finished if it is whole and without an anchor.
void AttachmentSearch::updateSetState(uint32_t index) {
    Set& set = m_sets[index];
    if (isOpen(index)) return m_open.push_back(index);
    if (set.parent != index || set.isAnchored || set.isFinished) return;
    set.isFinished = true;
    m_finishedVoxels += set.voxels;
    m_largestFinished = std::max(m_largestFinished, set.voxels);
}

/// Whether what stays is known: no set is open, or the only open one must be it.
bool AttachmentSearch::isDecided(const View& view) const {
    if (m_open.empty()) return true;
    if (m_open.size() > 1) return false;
    // Every set was connected to an anchor before the cut. If no anchor was carved and none was found, the last set has
    // it.
    if (m_isAnchored) return !m_anchorsCarved && !m_anchorFound;
    return view.grid.voxelCount() - m_finishedVoxels > m_largestFinished;
}

bool AttachmentSearch::run(const VoxelGrid& grid, std::span<const CellBox> anchors, size_t& budget) {
    const View view{grid, m_isAnchored ? anchors : std::span<const CellBox>{}};
    while (!isDecided(view)) {
        for (; m_turn < m_open.size(); ++m_turn) {
            if (budget == 0) return false;
            if (!isOpen(m_open[m_turn])) continue;
            grow(view, m_open[m_turn]);
            --budget;
        }
        m_turn = 0;
        std::vector<uint32_t> round;
        std::swap(round, m_open);
        for (const uint32_t set : round) updateSetState(set);
    }
    return true;
}

std::vector<Component> AttachmentSearch::finished(const VoxelGrid& grid) {
    std::vector<Component> out(
        size_t(std::count_if(m_sets.begin(), m_sets.end(), [](const Set& set) { return set.isFinished; })));
    std::vector<std::pair<uint32_t, Component*>> owned;  // part and its component
    size_t next = 0;
    for (const Set& set : m_sets) {
        if (!set.isFinished) continue;
        for (const uint32_t part : set.parts) owned.emplace_back(part, &out[next]);
        ++next;
    }
    // The parts of a node have consecutive numbers: sorted, they are adjacent.
    std::sort(owned.begin(), owned.end());
    std::vector<Component*> byPart;
    for (size_t i = 0; i < owned.size();) {
        const glm::ivec3 position = m_parts[owned[i].first].node;
        const BrickNode& node = *grid.nodeAt(position);
        byPart.assign(nodeParts(node).count, nullptr);
        for (; i < owned.size() && m_parts[owned[i].first].node == position; ++i)
            byPart[m_parts[owned[i].first].component] = owned[i].second;
        addNode(position, node, byPart);
    }
    for (Component& component : out) component.lowest = findLowest(component, grid);
    std::sort(out.begin(), out.end(),
              [](const Component& a, const Component& b) { return cellBefore(a.lowest, b.lowest); });
    return out;
}

}  // namespace rubble
