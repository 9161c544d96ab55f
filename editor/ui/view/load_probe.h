#pragma once
#include <glm/vec3.hpp>
#include <rubble/rubble.hpp>
#include <vector>

namespace editor {

/// Where a shape would break first under more load, found by trying: in a copy of the world its strength is halved
/// again and again, and it plays for a while with each.
struct LoadProbe {
    static constexpr int kLevels = 7;  ///< times that the load is doubled; 0: the present load

    /// A cell at which the shape came apart: it stayed, and its neighbour went.
    struct Cell {
        glm::ivec3 cell;
        int level;  ///< at 2^level times the load
    };
    rubble_shape shape = 0;
    std::vector<Cell> cells;  ///< those of the smaller loads first
    int weakest = -1;         ///< level of the first ones; -1: it bore all

    /// Tries a shape of a world, which stays as it is. Throws rubble::Error.
    static LoadProbe of(rubble::World& world, rubble_shape shape);
};

}  // namespace editor
