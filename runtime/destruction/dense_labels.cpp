#include "runtime/destruction/dense_labels.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "runtime/core/byte_bits.h"
#include "runtime/core/union_find.h"

namespace rubble {
namespace {

struct Run {
    uint32_t begin, end;  ///< along x, end excluded
};

/// One bit a cell for up to 64 cells of a row.
uint64_t rowBits(const uint8_t* cells, uint32_t count) {
    if (count == 64) return ~equalBits(cells, 0);
    uint64_t out = 0;
    uint32_t x = 0;
    for (; x + 8 <= count; x += 8) out |= gatherBits(nonZeroBytes(loadBytes(cells + x))) << x;
    for (; x < count; ++x) out |= uint64_t(cells[x] != 0) << x;
    return out;
}

void findRuns(const uint8_t* row, uint32_t length, std::vector<Run>& runs) {
    const size_t first = runs.size();
    for (uint32_t start = 0; start < length; start += 64) {
        uint64_t bits = rowBits(row + start, std::min(length - start, 64u));
        for (uint32_t x = 0; bits;) {
            const uint32_t empty = uint32_t(std::countr_zero(bits));
            bits >>= empty;
            const uint32_t solid = uint32_t(std::countr_one(bits));
            bits = solid == 64 ? 0 : bits >> solid;
            x += empty;
            if (runs.size() > first && runs.back().end == start + x)
                runs.back().end += solid;
            else
                runs.push_back({start + x, start + x + solid});
            x += solid;
        }
    }
}

/// Unites the runs of one row with those of another that touch them.
void uniteRows(const std::vector<Run>& runs, uint32_t a, uint32_t aEnd, uint32_t b, uint32_t bEnd, UnionFind<>& sets) {
    while (a < aEnd && b < bEnd) {
        if (runs[a].begin < runs[b].end && runs[b].begin < runs[a].end) sets.unite(a, b);
        runs[a].end < runs[b].end ? ++a : ++b;
    }
}

}  // namespace

std::vector<uint64_t> labelDense(glm::ivec3 size, std::span<const uint8_t> cells, std::span<uint32_t> labels) {
    const size_t rows = size_t(size.y) * size_t(size.z), length = size_t(size.x);
    assert(cells.size() == rows * length && labels.size() == cells.size());
    std::vector<Run> runs;
    std::vector<uint32_t> firstRun(rows + 1);
    UnionFind<> sets;
    for (size_t row = 0; row < rows; ++row) {
        findRuns(cells.data() + row * length, uint32_t(length), runs);
        const uint32_t first = firstRun[row], end = uint32_t(runs.size());
        firstRun[row + 1] = end;
        sets.grow(end);
        const size_t below = row - size_t(size.y);
        if (row % size_t(size.y) > 0) uniteRows(runs, first, end, firstRun[row - 1], first, sets);
        if (row >= size_t(size.y)) uniteRows(runs, first, end, firstRun[below], firstRun[below + 1], sets);
    }
    std::vector<uint64_t> voxels;
    std::vector<uint32_t> labelOf(runs.size());
    for (size_t row = 0; row < rows; ++row) {
        uint32_t* out = labels.data() + row * length;
        uint32_t x = 0;
        for (uint32_t i = firstRun[row]; i < firstRun[row + 1]; ++i) {
            const uint32_t root = sets.root(i);  // a set's root is its first run
            if (root == i) voxels.push_back(0);
            labelOf[i] = root == i ? uint32_t(voxels.size()) : labelOf[root];
            std::fill(out + x, out + runs[i].begin, 0u);
            std::fill(out + runs[i].begin, out + runs[i].end, labelOf[i]);
            voxels[labelOf[i] - 1] += runs[i].end - runs[i].begin;
            x = runs[i].end;
        }
        std::fill(out + x, out + length, 0u);
    }
    return voxels;
}

}  // namespace rubble
