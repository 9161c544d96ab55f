#pragma once
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace rubble {

/// A box of cells, high end excluded.
struct CellBox {
    glm::ivec3 low{0};
    glm::ivec3 high{0};
    bool empty() const { return low.x >= high.x || low.y >= high.y || low.z >= high.z; }
    friend bool operator==(const CellBox&, const CellBox&) = default;
};

/// The smallest box that holds both; an empty one adds nothing.
inline CellBox joined(const CellBox& a, const CellBox& b) {
    if (a.empty() || b.empty()) return a.empty() ? b : a;
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

}  // namespace rubble
