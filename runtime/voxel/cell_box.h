#pragma once
#include <glm/common.hpp>
#include <glm/vec3.hpp>

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

/// The smallest box that holds both. An empty box adds nothing.
inline CellBox joined(const CellBox& a, const CellBox& b) {
    if (a.empty() || b.empty()) return a.empty() ? b : a;
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

}  // namespace rubble
