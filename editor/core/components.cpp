#include "editor/core/components.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>
#include <utility>

namespace editor {
namespace {

constexpr int64_t kMaxSearched = int64_t(1) << 24;  ///< cells of a shape

template <class F>
void forEachNeighbour(glm::ivec3 cell, F&& f) {
    for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
            glm::ivec3 next = cell;
            next[axis] += step;
            f(next);
        }
}

}  // namespace

Components::Components(const rubble::World& world, rubble_shape shape) : m_grid(gridOf(world, shape)) {
    if (m_grid.count() > kMaxSearched) {
        m_grid = {};
        return;
    }
    const std::vector<uint8_t> voxels = readCells(world, shape, m_grid);
    m_of.resize(voxels.size());
    glm::ivec3 cell;
    const glm::ivec3 end = m_grid.low + m_grid.size;
    for (cell.z = m_grid.low.z; cell.z < end.z; ++cell.z)
        for (cell.y = m_grid.low.y; cell.y < end.y; ++cell.y)
            for (cell.x = m_grid.low.x; cell.x < end.x; ++cell.x)
                if (voxels[indexOf(cell)] && !m_of[indexOf(cell)]) gather(voxels, cell);
    sortBySize();
    for (const rubble_cell_box& box : world.get_anchors(shape))
        markAnchor({{box.low[0], box.low[1], box.low[2]}, {box.size[0], box.size[1], box.size[2]}});
}

size_t Components::indexOf(glm::ivec3 cell) const {
    const glm::ivec3 c = cell - m_grid.low;
    return (size_t(c.z) * size_t(m_grid.size.y) + size_t(c.y)) * size_t(m_grid.size.x) + size_t(c.x);
}

int Components::at(glm::ivec3 cell) const {
    return m_grid.contains(cell) ? int(m_of[indexOf(cell)] & ~kAnchored) - 1 : -1;
}

bool Components::isAnchored(glm::ivec3 cell) const {
    return m_grid.contains(cell) && m_of[indexOf(cell)] & kAnchored;
}

void Components::markAnchor(const Cells& anchor) {
    const Cells inside = shared(anchor, m_grid);
    const glm::ivec3 end = inside.low + inside.size;
    glm::ivec3 cell;
    for (cell.z = inside.low.z; cell.z < end.z; ++cell.z)
        for (cell.y = inside.low.y; cell.y < end.y; ++cell.y)
            for (cell.x = inside.low.x; cell.x < end.x; ++cell.x) {
                uint32_t& of = m_of[indexOf(cell)];
                if (of == 0 || of & kAnchored) continue;
                ++m_all[of - 1].anchored;
                of |= kAnchored;
            }
}

/// Adds the component of a cell.
void Components::gather(const std::vector<uint8_t>& voxels, glm::ivec3 start) {
    Component found;
    const auto number = uint32_t(m_all.size() + 1);
    glm::ivec3 low = start, high = start;
    std::vector<glm::ivec3> open{start};
    m_of[indexOf(start)] = number;
    while (!open.empty()) {
        const glm::ivec3 cell = open.back();
        open.pop_back();
        ++found.voxels;
        low = glm::min(low, cell), high = glm::max(high, cell);
        forEachNeighbour(cell, [&](glm::ivec3 next) {
            if (!m_grid.contains(next) || !voxels[indexOf(next)] || m_of[indexOf(next)]) return;
            m_of[indexOf(next)] = number;
            open.push_back(next);
        });
    }
    found.low = low, found.size = high - low + 1;
    m_all.push_back(found);
}

void Components::sortBySize() {
    std::vector<uint32_t> order(m_all.size()), places(m_all.size() + 1);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return m_all[a].voxels > m_all[b].voxels; });
    std::vector<Component> sorted;
    for (const uint32_t each : order) {
        sorted.push_back(m_all[each]);
        places[each + 1] = uint32_t(sorted.size());
    }
    m_all = std::move(sorted);
    for (uint32_t& each : m_of) each = places[each];
}

}  // namespace editor
