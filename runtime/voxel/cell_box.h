#pragma once
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace rubble {

/// A box of cells; `low` is inside, `high` is outside.
struct CellBox {
    glm::ivec3 low{0};
    glm::ivec3 high{0};
    /// Whether it holds no cell.
    bool empty() const { return low.x >= high.x || low.y >= high.y || low.z >= high.z; }
    /// Whether it holds a cell.
    bool contains(glm::ivec3 cell) const {
        return cell.x >= low.x && cell.y >= low.y && cell.z >= low.z && cell.x < high.x && cell.y < high.y &&
               cell.z < high.z;
    }
    friend bool operator==(const CellBox&, const CellBox&) = default;
};

/// The cell that holds a point (in cells). A point farther than a billion cells from the origin, or not a number,
/// counts as one at that distance: cells near it, and differences between cells, are integers too.
inline glm::ivec3 cellAt(const glm::dvec3& point) {
    constexpr double kFarthest = 1e9;
    return glm::ivec3(glm::floor(glm::min(glm::max(glm::dvec3(-kFarthest), point), kFarthest)));
}

/// The smallest box that holds both. An empty box adds nothing.
inline CellBox joined(const CellBox& a, const CellBox& b) {
    if (a.empty() || b.empty()) return a.empty() ? b : a;
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

/// Boxes in a frame of cells that begins at cell `low` of the present one and has this size; clipped to it. They may
/// reach to the ends of the integers.
inline std::vector<CellBox> translatedBoxes(const std::vector<CellBox>& boxes, glm::ivec3 low, glm::ivec3 size) {
    std::vector<CellBox> out;
    for (const CellBox& box : boxes) {
        const CellBox moved{glm::max(box.low, low) - low, glm::min(box.high, low + size) - low};
        if (!CellBox{glm::max(box.low, low), glm::min(box.high, low + size)}.empty()) out.push_back(moved);
    }
    return out;
}

}  // namespace rubble
