#include "runtime/destruction/box_connectivity.h"

#include <algorithm>
#include <array>
#include <glm/vector_relational.hpp>

// Flood fill of a small box on words of bits. A word holds four rows along x of 16 bits each; the last bit of a row
// stays empty and separates it from the next. A plane z is four words, with an empty word on either side, and there is
// an empty plane below and above, so neighbours need no test. The flood takes one cell as its seed and goes over all
// words in sweeps up and down, until a sweep reaches no new cell. Within a row it spreads to the whole run of open
// cells in a few operations: upwards by the carry of an addition, downwards by doubling steps (Kogge and Stone, "A
// parallel algorithm for the efficient solution of a general class of recurrence equations", IEEE Trans. Computers
// C-22, 1973).

namespace rubble {
namespace {

/// The bits of a box, with an empty border.
struct Window {
    static constexpr size_t kPlane = 6;  ///< words of a plane: four and the border
    static size_t index(int word, int z) { return size_t(z + 1) * kPlane + size_t(word + 1); }
    std::array<uint64_t, 18 * kPlane> words{};
};

/// 4 rows of 8 cells as rows of 16.
uint64_t spreadRows(uint64_t rows) {
    rows = (rows | rows << 16) & 0x0000ffff0000ffffull;
    return (rows | rows << 8) & 0x00ff00ff00ff00ffull;
}

/// Copies the cells of one brick that lie in a box of this size. `corner`: the brick's first cell, from the box's.
void addBrick(const Brick& brick, glm::ivec3 corner, glm::ivec3 size, Window& out) {
    const int words = (size.y + 3) / 4, fromZ = std::max(corner.z, 0), toZ = std::min(corner.z + kBrickSize, size.z);
    const uint64_t columns = 0xffull << std::max(-corner.x, 0) & 0xff >> std::max(corner.x + kBrickSize - size.x, 0);
    const uint64_t inside = spreadRows(columns * 0x01010101ull);
    for (int word = std::max(corner.y, 0) / 4; word < std::min((corner.y + kBrickSize + 3) / 4, words); ++word) {
        const int row = 4 * word - corner.y;  // of the brick: the first in this word
        for (int z = fromZ; z < toZ; ++z) {
            const uint64_t layer = brick.occupancy[size_t(z - corner.z)];
            const uint64_t cells = spreadRows((row < 0 ? layer << -8 * row : layer >> 8 * row) & 0xffffffff) & inside;
            out.words[Window::index(word, z)] |= corner.x < 0 ? cells >> -corner.x : cells << corner.x;
        }
    }
}

Window solidCells(const VoxelGrid& grid, const CellBox& box) {
    Window out;
    const glm::ivec3 size = box.high - box.low, low = brickOfCell(box.low), high = brickOfCell(box.high - 1);
    glm::ivec3 brick;
    for (brick.z = low.z; brick.z <= high.z; ++brick.z)
        for (brick.y = low.y; brick.y <= high.y; ++brick.y)
            for (brick.x = low.x; brick.x <= high.x; ++brick.x)
                if (const Brick* content = grid.brickAt(brick))
                    addBrick(*content, brick * kBrickSize - box.low, size, out);
    const int lastWord = (size.y - 1) / 4;
    if (size.y % 4)  // clear the rows beyond the box
        for (int z = 0; z < size.z; ++z) out.words[Window::index(lastWord, z)] &= ~uint64_t(0) >> 16 * (4 - size.y % 4);
    return out;
}

/// All cells of `open` that are connected to `cells` within four rows.
uint64_t fillRows(uint64_t cells, uint64_t open) {
    for (;;) {
        cells |= open & ~(open + cells);
        uint64_t propagate = open;
        for (const int step : {1, 2, 4, 8}) {
            cells |= propagate & cells >> step;
            propagate &= propagate >> step;
        }
        const uint64_t grown = cells | (open & (cells << 16 | cells >> 16));
        if (grown == cells) return cells;
        cells = grown;
    }
}

/// Whether all cells of a window are one component.
bool isConnected(const Window& window, glm::ivec3 size) {
    const auto& solid = window.words;
    const size_t first = Window::index(0, 0), last = Window::index((size.y - 1) / 4, size.z - 1);
    size_t start = first;
    while (start <= last && !solid[start]) ++start;
    if (start > last) return true;
    Window flood;
    auto& reached = flood.words;
    reached[start] = fillRows(solid[start] & -solid[start], solid[start]);
    for (bool isUp = true;; isUp = !isUp) {
        uint64_t left = 0;
        bool hasGrown = false;
        for (size_t i = 0; i <= last - first; ++i) {
            const size_t at = isUp ? first + i : last - i;
            const uint64_t beside = reached[at - Window::kPlane] | reached[at + Window::kPlane] |
                                    reached[at - 1] >> 48 | reached[at + 1] << 48;
            if (const uint64_t next = solid[at] & beside & ~reached[at]) {
                reached[at] = fillRows(reached[at] | next, solid[at]);
                hasGrown = true;
            }
            left |= solid[at] ^ reached[at];
        }
        if (!left) return true;
        if (!hasGrown) return false;
    }
}

}  // namespace

bool isConnectedInBox(const VoxelGrid& grid, const CellBox& box) {
    if (box.empty()) return true;
    const glm::ivec3 size = box.high - box.low;
    if (glm::any(glm::greaterThan(size, kMaxConnectivityBox))) return false;
    return isConnected(solidCells(grid, box), size);
}

}  // namespace rubble
