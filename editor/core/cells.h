#pragma once
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <rubble/rubble.hpp>
#include <vector>

#include "editor/core/selection.h"

namespace editor {

/// Cells that one command may look at at a time: what it needs of memory, in bytes.
inline constexpr int64_t kMaxCells = int64_t(1) << 27;

/// A box of cells.
struct Cells {
    glm::ivec3 low{0}, size{0};

    /// Whether it holds a cell.
    bool contains(glm::ivec3 cell) const {
        for (int a = 0; a < 3; ++a)
            if (cell[a] < low[a] || cell[a] >= low[a] + size[a]) return false;
        return true;
    }
    /// Whether it holds none.
    bool isEmpty() const { return size.x <= 0 || size.y <= 0 || size.z <= 0; }
    /// How many it holds.
    int64_t count() const { return isEmpty() ? 0 : int64_t(size.x) * size.y * size.z; }
};
/// The box around two cells and all between them.
Cells between(glm::ivec3 a, glm::ivec3 b);
/// The box around two boxes; of an empty one the other.
Cells joined(const Cells& a, const Cells& b);
/// What two boxes share.
Cells shared(const Cells& a, const Cells& b);
/// The grid of a shape.
Cells gridOf(const rubble::World& world, rubble_shape shape);

/// The voxels of a box as the last edit left them: indices of the palette, x fastest, then y, then z; 0 outside of the
/// grid. Throws Refused of more than kMaxCells.
std::vector<uint8_t> readCells(const rubble::World& world, rubble_shape shape, const Cells& box);
/// Calls f(layer, voxels) for each layer of cells of a box along z, with voxels as readCells() gives them.
template <class F>
void forEachLayer(const rubble::World& world, rubble_shape shape, Cells box, F&& f) {
    for (const int end = box.low.z + box.size.z; box.low.z < end; ++box.low.z) {
        box.size.z = 1;
        f(box, readCells(world, shape, box));
    }
}
/// The least box that holds all voxels of a shape; an empty one: it has none.
Cells solidOf(const rubble::World& world, rubble_shape shape);
/// All cells that are joined to one by faces and hold the same as it; within the grid.
CellSet connectedCells(const rubble::World& world, rubble_shape shape, glm::ivec3 start);

/// Queues other voxels for a shape. Cells are those of its grid as the last edit left it, also where it grows. It reads
/// what was there before its own writes: each cell once, for each command.
class CellWriter {
public:
    /// For one command. Both outlive it.
    CellWriter(rubble::World& world, rubble_shape shape);

    /// Grows the grid so that it holds a box, at once: before the first write.
    void makeRoom(const Cells& box);
    /// change(cell, index) gives what shall be in each cell of a box. Cells beyond the grid are left out.
    void write(const Cells& box, const std::function<uint8_t(glm::ivec3, uint8_t)>& change);

private:
    void writeTile(const Cells& tile, const std::function<uint8_t(glm::ivec3, uint8_t)>& change);

    rubble::World& m_world;
    rubble_shape m_shape;
    Cells m_grid;  ///< with the room that was made
};

}  // namespace editor
