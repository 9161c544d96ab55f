#include "runtime/destruction/box_connectivity.h"

#include <algorithm>
#include <array>
#include <glm/vector_relational.hpp>

namespace rubble {
namespace {

/// The cells of a small box: a word holds four rows along x, each of sixteen bits with the last one empty, a plane four
/// words, with empty ones around them.
struct Window {
    static constexpr size_t kPlane = 6;
    static size_t place(int word, int z) { return size_t(z + 1) * kPlane + size_t(word + 1); }
    std::array<uint64_t, 18 * kPlane> words{};
};

/// Four rows of eight cells as four of sixteen.
uint64_t spreadRows(uint64_t rows) {
    rows = (rows | rows << 16) & 0x0000ffff0000ffffull;
    return (rows | rows << 8) & 0x00ff00ff00ff00ffull;
}

Window solidCells(const VoxelGrid& grid, const CellBox& box) {
    Window out;
    const glm::ivec3 size = box.high - box.low, low = box.low >> 3, high = (box.high - 1) >> 3;
    const int words = (size.y + 3) / 4;
    glm::ivec3 brick;
    for (brick.z = low.z; brick.z <= high.z; ++brick.z)
        for (brick.y = low.y; brick.y <= high.y; ++brick.y)
            for (brick.x = low.x; brick.x <= high.x; ++brick.x) {
                const Brick* content = grid.brickAt(brick);
                if (!content) continue;
                const glm::ivec3 corner = brick * kBrickSize - box.low;
                const int fromZ = std::max(corner.z, 0), toZ = std::min(corner.z + kBrickSize, size.z);
                // Cells beyond the box along x, of eight: below it, or above.
                const uint64_t inside = spreadRows(
                    (0xffull << std::max(-corner.x, 0) & 0xff >> std::max(corner.x + kBrickSize - size.x, 0)) *
                    0x01010101ull);
                for (int word = std::max(corner.y, 0) / 4; word < std::min((corner.y + kBrickSize + 3) / 4, words);
                     ++word) {
                    const int row = 4 * word - corner.y;  // of the brick, at the word's first
                    for (int z = fromZ; z < toZ; ++z) {
                        const uint64_t layer = content->occupancy[size_t(z - corner.z)];
                        const uint64_t cells =
                            spreadRows((row < 0 ? layer << -8 * row : layer >> 8 * row) & 0xffffffff) & inside;
                        out.words[Window::place(word, z)] |= corner.x < 0 ? cells >> -corner.x : cells << corner.x;
                    }
                }
            }
    if (size.y % 4)  // rows beyond the box
        for (int z = 0; z < size.z; ++z)
            out.words[Window::place(words - 1, z)] &= ~uint64_t(0) >> 16 * (4 - size.y % 4);
    return out;
}

/// All cells of four rows that some of them reach: along x upwards by the carry of an addition, downwards by doubling
/// (Kogge & Stone 1973), along y by steps.
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

/// Whether all cells of a window hang together inside it: a flood in sweeps up and down.
bool isConnected(const Window& window, glm::ivec3 size) {
    const std::array<uint64_t, 18 * Window::kPlane>& solid = window.words;
    const size_t first = Window::place(0, 0), last = Window::place((size.y - 1) / 4, size.z - 1);
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
