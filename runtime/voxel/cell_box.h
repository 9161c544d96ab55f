#pragma once
#include <glm/vec3.hpp>

namespace rubble {

/// A box of cells, high end excluded.
struct CellBox {
    glm::ivec3 low{0};
    glm::ivec3 high{0};
    bool empty() const { return low.x >= high.x || low.y >= high.y || low.z >= high.z; }
    friend bool operator==(const CellBox&, const CellBox&) = default;
};

}  // namespace rubble
