#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <rubble/rubble.hpp>
#include <vector>

namespace editor {

/// Cells of one shape: a box of its grid, and which cells of it, x fastest, then y, then z.
struct CellSet {
    rubble_shape shape = 0;  ///< 0: of none
    glm::ivec3 low{0}, size{0};
    std::vector<uint8_t> mask;  ///< 1: in the set

    /// Where a cell of the box is in the mask.
    size_t at(glm::ivec3 cell) const {
        const glm::ivec3 c = cell - low;
        return (size_t(c.z) * size_t(size.y) + size_t(c.y)) * size_t(size.x) + size_t(c.x);
    }
};

/// What is selected. It is no part of the level: no step of the history knows it.
struct Selection {
    std::vector<uint64_t> objects;  ///< bodies, shapes, lights, joints: in the order in which they were selected
    CellSet cells;
};

/// Cells that were copied.
struct Clipboard {
    glm::ivec3 size{0};
    std::vector<uint8_t> voxels;  ///< indices of the palette, 0: none; as read_voxels() gives them
};

}  // namespace editor
