#include "tests/benchmark/baseline_labels.h"

#include <algorithm>
#include <cstring>

namespace rubble::bench {
namespace {

struct Run {
    uint16_t begin, end;
};

struct UnionFind {
    std::vector<uint32_t> parent;
    uint32_t root(uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    }
    void unite(uint32_t a, uint32_t b) {
        a = root(a), b = root(b);
        if (a != b) parent[std::max(a, b)] = std::min(a, b);
    }
};

/// The first x where the run of zeros (or of non-zeros) ends; compares eight bytes at a time where possible.
int skip(const uint8_t* row, int x, int end, bool zeros) {
    for (; x + 8 <= end; x += 8) {
        uint64_t word;
        std::memcpy(&word, row + x, 8);
        const uint64_t zeroBytes = (word - 0x0101010101010101ull) & ~word & 0x8080808080808080ull;
        if (zeros ? word != 0 : zeroBytes != 0) break;
    }
    while (x < end && (row[x] == 0) == zeros) ++x;
    return x;
}

/// Unites the runs of two rows that overlap.
void uniteRows(const std::vector<Run>& runs, uint32_t a, uint32_t aEnd, uint32_t b, uint32_t bEnd, UnionFind& sets) {
    while (a < aEnd && b < bEnd) {
        if (runs[a].begin < runs[b].end && runs[b].begin < runs[a].end) sets.unite(a, b);
        runs[a].end < runs[b].end ? ++a : ++b;
    }
}

}  // namespace

DenseGrid::DenseGrid(const VoxelGrid& grid) : size(grid.size()), cells(size_t(size.x) * size.y * size.z) {
    grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
        forEachVoxel(content->occupancy, [&](int i) {
            const glm::ivec3 c = brick * kBrickSize + voxelInBrick(i);
            cells[(size_t(c.z) * size.y + c.y) * size.x + c.x] = content->at(i);
        });
    });
}

size_t countComponentsByRuns(const DenseGrid& grid) {
    const size_t rows = size_t(grid.size.y) * grid.size.z;
    std::vector<Run> runs;
    std::vector<uint32_t> firstRun(rows + 1);
    UnionFind sets;
    for (size_t row = 0; row < rows; ++row) {
        firstRun[row] = uint32_t(runs.size());
        const uint8_t* cells = grid.cells.data() + row * grid.size.x;
        for (int x = skip(cells, 0, grid.size.x, true); x < grid.size.x;) {
            const int end = skip(cells, x, grid.size.x, false);
            runs.push_back({uint16_t(x), uint16_t(end)});
            sets.parent.push_back(uint32_t(sets.parent.size()));
            x = skip(cells, end, grid.size.x, true);
        }
        firstRun[row + 1] = uint32_t(runs.size());
        const size_t y = row % grid.size.y, before = row - grid.size.y;
        if (y > 0) uniteRows(runs, firstRun[row], firstRun[row + 1], firstRun[row - 1], firstRun[row], sets);
        if (row >= size_t(grid.size.y))
            uniteRows(runs, firstRun[row], firstRun[row + 1], firstRun[before], firstRun[before + 1], sets);
    }
    size_t components = 0;
    for (uint32_t i = 0; i < sets.parent.size(); ++i) components += sets.root(i) == i;
    return components;
}

}  // namespace rubble::bench
