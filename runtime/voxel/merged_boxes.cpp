#include "runtime/voxel/merged_boxes.h"

#include <algorithm>
#include <bit>
#include <span>
#include <tuple>

namespace rubble {
namespace {

struct PlacedBrick {
    glm::ivec3 at;
    const Brick* brick;
};

auto byLayer(const PlacedBrick& placed) {
    return std::tuple(placed.at.z, placed.at.y, placed.at.x);
}

/// The order in which boxes of a row, or of a layer, are found and compared.
auto place(const CellBox& box) {
    return std::tuple(box.low.y, box.low.x, box.high.y, box.high.x);
}

/// The voxels of a row of a brick that count, one bit each.
unsigned rowBits(const Brick& brick, int y, int z, const std::bitset<256>& entries) {
    unsigned bits = unsigned(brick.occupancy[size_t(z)] >> (8 * y)) & 255u;
    if (!brick.indices) return entries[brick.uniform] ? bits : 0u;
    for (unsigned left = bits; left; left &= left - 1) {
        const int x = std::countr_zero(left);
        if (!entries[(*brick.indices)[size_t(voxelIndex({x, y, z}))]]) bits &= ~(1u << x);
    }
    return bits;
}

/// Appends the runs of voxels of one row, at y and z of the grid.
void addRuns(std::span<const PlacedBrick> row, int y, int z, const std::bitset<256>& entries,
             std::vector<CellBox>& out) {
    const size_t first = out.size();
    for (const PlacedBrick& placed : row) {
        unsigned bits = rowBits(*placed.brick, cellInBrick(y), cellInBrick(z), entries);
        for (int x = placed.at.x * kBrickSize; bits;) {
            const int gap = std::countr_zero(bits);
            const int length = std::countr_one(bits >> gap);
            x += gap;
            if (out.size() > first && out.back().high.x == x)
                out.back().high.x += length;
            else
                out.push_back({{x, y, z}, {x + length, y + 1, z + 1}});
            x += length;
            bits = bits >> gap >> length;
        }
    }
}

/// Moves into `closed` what no box of `next` continues, and lets the others grow along `axis`; `next` becomes what is
/// open. Both are in the order of less.
template <class Less>
void grow(std::vector<CellBox>& open, std::vector<CellBox>& next, int axis, Less less, std::vector<CellBox>& closed) {
    auto old = open.begin();
    for (CellBox& box : next) {
        while (old != open.end() && less(*old, box)) closed.push_back(*old++);
        if (old == open.end() || less(box, *old)) continue;
        box.low[axis] = old->low[axis];
        ++old;
    }
    closed.insert(closed.end(), old, open.end());
    std::swap(open, next);
}

/// Rectangles of one layer of cells, by place().
std::vector<CellBox> layerBoxes(std::span<const PlacedBrick> layer, int z, const std::bitset<256>& entries) {
    const auto isLeftOf = [](const CellBox& a, const CellBox& b) {
        return std::tuple(a.low.x, a.high.x) < std::tuple(b.low.x, b.high.x);
    };
    std::vector<CellBox> out, open, runs;
    for (size_t begin = 0, end = 0; begin < layer.size(); begin = end) {
        const int brickY = layer[begin].at.y;
        while (end < layer.size() && layer[end].at.y == brickY) ++end;
        for (int y = brickY * kBrickSize; y < (brickY + 1) * kBrickSize; ++y) {
            if (!open.empty() && open.front().high.y != y) {  // behind a gap of bricks
                out.insert(out.end(), open.begin(), open.end());
                open.clear();
            }
            runs.clear();
            addRuns(layer.subspan(begin, end - begin), y, z, entries, runs);
            grow(open, runs, 1, isLeftOf, out);
        }
    }
    out.insert(out.end(), open.begin(), open.end());
    std::sort(out.begin(), out.end(), [](const CellBox& a, const CellBox& b) { return place(a) < place(b); });
    return out;
}

}  // namespace

std::vector<CellBox> mergedBoxes(const VoxelGrid& grid, const std::bitset<256>& entries) {
    std::vector<PlacedBrick> bricks;
    bricks.reserve(grid.brickCount());
    grid.forEachBrick([&](glm::ivec3 at, const BrickRef& brick) { bricks.push_back({at, brick.get()}); });
    std::sort(bricks.begin(), bricks.end(),
              [](const PlacedBrick& a, const PlacedBrick& b) { return byLayer(a) < byLayer(b); });
    const auto isBefore = [](const CellBox& a, const CellBox& b) { return place(a) < place(b); };
    std::vector<CellBox> out, open;
    for (size_t begin = 0, end = 0; begin < bricks.size(); begin = end) {
        const int brickZ = bricks[begin].at.z;
        while (end < bricks.size() && bricks[end].at.z == brickZ) ++end;
        for (int z = brickZ * kBrickSize; z < (brickZ + 1) * kBrickSize; ++z) {
            if (!open.empty() && open.front().high.z != z) {  // behind a gap of bricks
                out.insert(out.end(), open.begin(), open.end());
                open.clear();
            }
            std::vector<CellBox> layer = layerBoxes({bricks.data() + begin, end - begin}, z, entries);
            grow(open, layer, 2, isBefore, out);
        }
    }
    out.insert(out.end(), open.begin(), open.end());
    return out;
}

}  // namespace rubble
