#include "runtime/destruction/attachment_search.h"

#include <algorithm>
#include <glm/common.hpp>

namespace rubble {

AttachmentSearch::AttachmentSearch(const VoxelGrid& grid, std::span<const CellBox> anchors, std::span<const glm::ivec3> carved)
    : m_grid(grid), m_anchors(anchors) {
    const auto seed = [&](glm::ivec3 brick) {
        const Range range = partsOf(brick);
        for (uint32_t part = range.first; part < range.end; ++part) {
            if (m_parts[part].set != kNone) continue;
            m_sets.push_back({.parent = uint32_t(m_sets.size())});
            addPart(uint32_t(m_sets.size() - 1), part);
        }
    };
    constexpr BrickBits kEveryCell = {~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull};
    for (const glm::ivec3 brick : carved) {
        m_anchorsTouched = m_anchorsTouched || touchesAnchor({brick, kEveryCell}, anchors);
        seed(brick);
        for (const glm::ivec3 step : kFaceSteps) seed(brick + step);
    }
    // What already meets among the seeds is one set before anything grows.
    const uint32_t seeds = uint32_t(m_parts.size());
    for (uint32_t part = 0; part < seeds; ++part)
        for (size_t face = 1; face < 6; face += 2) {
            const glm::ivec3 other = m_parts[part].brick + kFaceSteps[face];
            if (m_bricks.contains(uint32_t(other.x) | uint32_t(other.y) << 10 | uint32_t(other.z) << 20)) visitNeighbour(part, face);
        }
    for (uint32_t set = 0; set < m_sets.size(); ++set)
        if (root(set) == set && isOpen(set)) m_open.push_back(set);
}

AttachmentSearch::Range AttachmentSearch::partsOf(glm::ivec3 brick) {
    static_assert(kMaxGridSize / kBrickSize <= 1024, "ten bits an axis");
    const Brick* content = m_grid.brickAt(brick);
    if (!content) return {};
    const auto [entry, isNew] = m_bricks.try_emplace(uint32_t(brick.x) | uint32_t(brick.y) << 10 | uint32_t(brick.z) << 20);
    if (isNew) {
        m_scratch.clear();
        findBrickParts(content->occupancy, m_scratch);
        entry->second.first = uint32_t(m_parts.size());
        for (const BrickPart& part : m_scratch) m_parts.push_back({part, brick, kNone});
        entry->second.end = uint32_t(m_parts.size());
    }
    return entry->second;
}

uint32_t AttachmentSearch::root(uint32_t set) {
    while (m_sets[set].parent != set) set = m_sets[set].parent = m_sets[m_sets[set].parent].parent;
    return set;
}

int AttachmentSearch::anchorDistance(glm::ivec3 brick) const {
    int nearest = m_anchors.empty() ? 0 : INT32_MAX;
    const glm::ivec3 middle = brick * kBrickSize + kBrickSize / 2;
    for (const CellBox& box : m_anchors) {
        const glm::ivec3 away = glm::max(glm::max(box.low - middle, middle - box.high), 0);
        nearest = std::min(nearest, away.x + away.y + away.z);
    }
    return nearest;
}

void AttachmentSearch::addPart(uint32_t set, uint32_t index) {
    Part& part = m_parts[index];
    Set& into = m_sets[set];
    part.set = set;
    for (uint64_t layer : part.cells.voxels) into.voxels += uint64_t(std::popcount(layer));
    into.isAnchored = into.isAnchored || touchesAnchor({part.brick, part.cells.voxels}, m_anchors);
    into.parts.push_back(index);
    into.frontier.push_back({anchorDistance(part.brick), index});
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

void AttachmentSearch::visitNeighbour(uint32_t index, size_t face) {
    if (!m_parts[index].cells.faces[face]) return;
    const Range range = partsOf(m_parts[index].brick + kFaceSteps[face]);
    for (uint32_t other = range.first; other < range.end; ++other) {
        if (!(m_parts[index].cells.faces[face] & m_parts[other].cells.faces[face ^ 1])) continue;
        const uint32_t set = root(m_parts[index].set);
        if (m_parts[other].set == kNone)
            addPart(set, other);
        else
            join(set, m_parts[other].set);
    }
}

void AttachmentSearch::grow(uint32_t set) {
    std::vector<Frontier>& frontier = m_sets[set].frontier;
    std::pop_heap(frontier.begin(), frontier.end(), std::greater<>());
    const uint32_t part = frontier.back().part;
    frontier.pop_back();
    for (size_t face = 0; face < 6; ++face) visitNeighbour(part, face);
}

bool AttachmentSearch::isOpen(uint32_t set) const {
    return m_sets[set].parent == set && !m_sets[set].isAnchored && !m_sets[set].frontier.empty();
}

/// Whether the one set that may still grow can only be what stays.
bool AttachmentSearch::isSettled(bool isAnchored) {
    if (m_open.empty()) return true;
    if (m_open.size() > 1) return false;
    uint64_t finished = 0, largest = 0;
    bool hasAnchored = false;
    for (uint32_t set = 0; set < m_sets.size(); ++set) {
        if (m_sets[set].parent != set || set == m_open.front()) continue;
        hasAnchored = hasAnchored || m_sets[set].isAnchored;
        finished += m_sets[set].voxels;
        largest = std::max(largest, m_sets[set].voxels);
    }
    // Everything that was cut hung on an anchor; if no anchor was cut and no other set has it, the last one does.
    if (isAnchored) return !m_anchorsTouched && !hasAnchored;
    return m_grid.voxelCount() - finished > largest;
}

bool AttachmentSearch::run(bool isAnchored, size_t budget) {
    constexpr int kPartsATurn = 8;
    while (!isSettled(isAnchored)) {
        if (m_parts.size() > budget) return false;
        for (const uint32_t set : m_open)
            for (int turn = 0; turn < kPartsATurn && isOpen(set); ++turn) grow(set);
        std::erase_if(m_open, [&](uint32_t set) { return !isOpen(set); });
    }
    return true;
}

std::vector<Component> AttachmentSearch::takeFinished() {
    std::vector<Component> out;
    for (Set& set : m_sets) {
        if (m_sets[set.parent].parent != uint32_t(&set - m_sets.data()) || set.isAnchored || !set.frontier.empty()) continue;
        Component component;
        component.voxels = set.voxels;
        std::sort(set.parts.begin(), set.parts.end(), [&](uint32_t a, uint32_t b) { return cellBefore(m_parts[a].brick, m_parts[b].brick); });
        for (const uint32_t index : set.parts) {
            const Part& part = m_parts[index];
            if (!component.shares.empty() && component.shares.back().brick == part.brick)
                for (size_t z = 0; z < 8; ++z) component.shares.back().voxels[z] |= part.cells.voxels[z];
            else
                component.shares.push_back({part.brick, part.cells.voxels});
        }
        component.lowest = lowestCell(component.shares.front());
        for (const BrickShare& share : component.shares)
            if (const glm::ivec3 cell = lowestCell(share); cellBefore(cell, component.lowest)) component.lowest = cell;
        out.push_back(std::move(component));
    }
    std::sort(out.begin(), out.end(), [](const Component& a, const Component& b) { return cellBefore(a.lowest, b.lowest); });
    return out;
}

}  // namespace rubble
