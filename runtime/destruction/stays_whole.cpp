#include "runtime/destruction/stays_whole.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <optional>

#include "runtime/core/union_find.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {
namespace {

constexpr int kMostPlaces = 343;     ///< of bricks in the box around the cut: a larger cut is better searched by nodes
constexpr uint8_t kCarved = 1 << 6;  ///< a brick that was carved; lower bits: its faces that look at one
constexpr uint8_t kAllFaces = 0x3f;

/// The bricks around a cut: the carved ones, and those that share a face with one.
struct Surroundings {
    CellBox box;  ///< of bricks
    std::array<uint8_t, kMostPlaces> roles{};
    std::array<std::span<const BrickPart>, kMostPlaces> parts;
    std::array<uint16_t, kMostPlaces + 1> firstPart{};

    glm::ivec3 size() const { return box.high - box.low; }
    int places() const { return size().x * size().y * size().z; }
    int place(glm::ivec3 brick) const {
        const glm::ivec3 at = brick - box.low;
        return (at.z * size().y + at.y) * size().x + at.x;
    }
    bool contains(glm::ivec3 brick) const { return glm::all(glm::greaterThanEqual(brick, box.low)) && glm::all(glm::lessThan(brick, box.high)); }
};

CellBox boxAround(const VoxelGrid& grid, const BrickSet& carved) {
    CellBox box{grid.sizeInBricks(), glm::ivec3(0)};
    carved.forEachNode([&](glm::ivec3 node, BrickMask bricks) {
        forEachChild(bricks, [&](int child) {
            const glm::ivec3 brick = node * kNodeBricks + childPosition(child);
            box = {glm::min(box.low, brick - 1), glm::max(box.high, brick + 2)};
        });
    });
    return {glm::max(box.low, 0), glm::min(box.high, grid.sizeInBricks())};
}

/// False if some brick has too many parts to keep them.
bool findParts(const VoxelGrid& grid, Surroundings& near) {
    std::vector<BrickPart> scratch;
    int place = 0;
    for (int z = near.box.low.z; z < near.box.high.z; ++z)
        for (int y = near.box.low.y; y < near.box.high.y; ++y)
            for (int x = near.box.low.x; x < near.box.high.x; ++x, ++place) {
                auto& parts = near.parts[size_t(place)];
                if (near.roles[size_t(place)])
                    if (const Brick* brick = grid.brickAt({x, y, z})) parts = brickParts(*brick, scratch);
                if (!parts.empty() && parts.data() == scratch.data()) return false;
                near.firstPart[size_t(place) + 1] = uint16_t(near.firstPart[size_t(place)] + parts.size());
            }
    return true;
}

void joinAlong(const Surroundings& near, size_t axis, UnionFind<uint16_t>& sets) {
    const int step = axis == 0 ? 1 : axis == 1 ? near.size().x : near.size().x * near.size().y;
    const size_t face = 2 * axis + 1;
    for (int place = 0; place + step < near.places(); ++place) {
        const auto a = near.parts[size_t(place)], b = near.parts[size_t(place + step)];
        if (a.empty() || b.empty() || place / step % near.size()[int(axis)] == near.size()[int(axis)] - 1) continue;
        for (size_t i = 0; i < a.size(); ++i)
            for (size_t j = 0; a[i].faces[face] && j < b.size(); ++j)
                if (a[i].faces[face] & b[j].faces[face ^ 1])
                    sets.unite(uint16_t(near.firstPart[size_t(place)] + i), uint16_t(near.firstPart[size_t(place + step)] + j));
    }
}

/// The most cells of a small cut with one cell around it.
constexpr glm::ivec3 kSmall(15, 16, 16);

/// The cells of a small box: a word holds four rows along x, each of sixteen bits with the last one empty, a plane four words,
/// with empty ones around them.
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
                const uint64_t inside =
                    spreadRows((0xffull << std::max(-corner.x, 0) & 0xff >> std::max(corner.x + kBrickSize - size.x, 0)) * 0x01010101ull);
                for (int word = std::max(corner.y, 0) / 4; word < std::min((corner.y + kBrickSize + 3) / 4, words); ++word) {
                    const int row = 4 * word - corner.y;  // of the brick, at the word's first
                    for (int z = fromZ; z < toZ; ++z) {
                        const uint64_t layer = content->occupancy[size_t(z - corner.z)];
                        const uint64_t cells = spreadRows((row < 0 ? layer << -8 * row : layer >> 8 * row) & 0xffffffff) & inside;
                        out.words[Window::place(word, z)] |= corner.x < 0 ? cells >> -corner.x : cells << corner.x;
                    }
                }
            }
    if (size.y % 4)  // rows beyond the box
        for (int z = 0; z < size.z; ++z) out.words[Window::place(words - 1, z)] &= ~uint64_t(0) >> 16 * (4 - size.y % 4);
    return out;
}

/// All cells of four rows that some of them reach: along x upwards by the carry of an addition, downwards by doubling (Kogge &
/// Stone 1973), along y by steps.
uint64_t fillRows(uint64_t cells, uint64_t open) {
    for (;;) {
        cells |= open & ~(open + cells);
        uint64_t way = open;
        for (const int step : {1, 2, 4, 8}) {
            cells |= way & cells >> step;
            way &= way >> step;
        }
        const uint64_t grown = cells | (open & (cells << 16 | cells >> 16));
        if (grown == cells) return cells;
        cells = grown;
    }
}

/// Whether all cells of a window hang together inside it: a flood in sweeps up and down.
bool hangsTogether(const Window& window, glm::ivec3 size) {
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
            const uint64_t beside = reached[at - Window::kPlane] | reached[at + Window::kPlane] | reached[at - 1] >> 48 | reached[at + 1] << 48;
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

bool staysWhole(const VoxelGrid& grid, const CellBox& lost, std::span<const CellBox> anchors) {
    const CellBox box{glm::max(lost.low - 1, 0), glm::min(lost.high + 1, grid.size())};
    if (box.empty()) return true;
    const glm::ivec3 size = box.high - box.low;
    if (glm::any(glm::greaterThan(size, kSmall))) return false;
    for (const CellBox& anchor : anchors)
        if (glm::all(glm::lessThan(anchor.low, lost.high)) && glm::all(glm::lessThan(lost.low, anchor.high))) return false;
    return hangsTogether(solidCells(grid, box), size);
}

bool staysWhole(const VoxelGrid& grid, const BrickSet& carved) {
    Surroundings near;
    near.box = boxAround(grid, carved);
    if (near.box.empty() || near.size().x > kMostPlaces || near.size().y > kMostPlaces || near.places() > kMostPlaces) return false;
    carved.forEach([&](glm::ivec3 brick) {
        near.roles[size_t(near.place(brick))] |= kCarved | kAllFaces;
        for (size_t face = 0; face < 6; ++face)
            if (const glm::ivec3 other = brick + kFaceSteps[face]; near.contains(other))
                near.roles[size_t(near.place(other))] |= uint8_t(1 << (face ^ 1));
    });
    if (!findParts(grid, near)) return false;
    UnionFind<uint16_t> sets(near.firstPart[size_t(near.places())]);
    for (size_t axis = 0; axis < 3; ++axis) joinAlong(near, axis, sets);
    std::optional<uint16_t> whole;
    for (int place = 0; place < near.places(); ++place)
        for (size_t i = 0; i < near.parts[size_t(place)].size(); ++i) {
            const uint8_t role = near.roles[size_t(place)];
            bool touches = role & kCarved;
            for (size_t face = 0; face < 6 && !touches; ++face) touches = (role >> face & 1) && near.parts[size_t(place)][i].faces[face];
            if (!touches) continue;
            const uint16_t set = sets.root(uint16_t(near.firstPart[size_t(place)] + i));
            if (whole && *whole != set) return false;
            whole = set;
        }
    return true;
}

}  // namespace rubble
