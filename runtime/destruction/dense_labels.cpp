#include "runtime/destruction/dense_labels.h"

#include <algorithm>
#include <cassert>

#include "runtime/core/byte_bits.h"
#include "runtime/destruction/run_sets.h"

namespace rubble {
namespace {

/// One bit a cell.
void readRow(std::span<const uint8_t> cells, std::vector<uint64_t>& out) {
    const size_t whole = cells.size() / 64;
    for (size_t w = 0; w < whole; ++w) out[w] = ~equalBits(cells.data() + 64 * w, 0);
    if (whole < out.size()) out[whole] = 0;
    for (size_t x = 64 * whole; x < cells.size(); ++x) out[whole] |= uint64_t(cells[x] != 0) << (x & 63);
}

}  // namespace

std::vector<uint64_t> labelDense(glm::ivec3 size, std::span<const uint8_t> cells, std::span<uint32_t> labels) {
    const size_t rows = size_t(size.y) * size_t(size.z), length = size_t(size.x);
    assert(cells.size() == rows * length && labels.size() == cells.size());
    RunSets sets(size);
    std::vector<uint64_t> bits(sets.wordsARow()), voxels;
    for (size_t row = 0; row < rows; ++row) {
        readRow(cells.subspan(row * length, length), bits);
        sets.add(bits);
    }
    const std::vector<uint32_t> numbers = sets.number(voxels);
    size_t run = 0;
    for (size_t row = 0; row < rows; ++row) {
        uint32_t *out = labels.data() + row * length, x = 0;
        readRow(cells.subspan(row * length, length), bits);
        forEachRun(bits, [&](uint32_t begin, uint32_t end) {
            fillRun(out, x, begin, 0);
            fillRun(out, begin, end, numbers[run++] + 1);
            x = end;
        });
        std::fill(out + x, out + length, 0u);
    }
    return voxels;
}

}  // namespace rubble
