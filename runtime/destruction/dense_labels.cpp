#include "runtime/destruction/dense_labels.h"

#include <algorithm>

#include "runtime/core/assertion.h"
#include "runtime/core/byte_bits.h"
#include "runtime/destruction/run_labels.h"

namespace rubble {
namespace {

/// A row of cells as one bit for each.
void readRow(std::span<const uint8_t> cells, std::vector<uint64_t>& out) {
    const size_t whole = cells.size() / 64;
    for (size_t w = 0; w < whole; ++w) out[w] = ~equalBits(cells.data() + 64 * w, 0);
    if (whole < out.size()) out[whole] = 0;
    for (size_t x = 64 * whole; x < cells.size(); ++x) out[whole] |= uint64_t(cells[x] != 0) << (x & 63);
}

/// fillRun() for a row that begins with zeros: writes zeros beyond the run, by masks instead of branches.
void writeRun(uint32_t* out, uint32_t length, uint32_t value) {
    constexpr uint64_t kNone = 0, kOne = 0xffffffff, kTwo = ~0ull;
    static constexpr uint64_t kMasks[5][2] = {{kNone, kNone}, {kOne, kNone}, {kTwo, kNone}, {kTwo, kOne}, {kTwo, kTwo}};
    for (; length > 4; length -= 4, out += 4) fillRun(out, 0, 4, value);
    const uint64_t two = value * 0x0000000100000001ull, four[2] = {two & kMasks[length][0], two & kMasks[length][1]};
    std::memcpy(out, four, sizeof four);
}

}  // namespace

std::vector<uint64_t> labelDense(glm::ivec3 size, std::span<const uint8_t> cells, std::span<uint32_t> labels) {
    const size_t rows = size_t(size.y) * size_t(size.z), length = size_t(size.x);
    RUBBLE_ASSERT(cells.size() == rows * length && labels.size() == cells.size());
    RunLabels sets(size, true);
    std::vector<uint64_t> bits(sets.wordsPerRow());
    for (size_t row = 0; row < rows; ++row) {
        readRow(cells.subspan(row * length, length), bits);
        sets.add(bits);
    }
    const std::vector<uint64_t> voxels = sets.countComponents();
    auto component = sets.runs().begin();
    std::vector<uint32_t> out(length + kFillPadding);
    for (size_t row = 0; row < rows; ++row) {
        std::fill(out.begin(), out.end(), 0);
        readRow(cells.subspan(row * length, length), bits);
        forEachRun(bits,
                   [&](uint32_t begin, uint32_t end) { writeRun(out.data() + begin, end - begin, *component++ + 1); });
        std::memcpy(labels.data() + row * length, out.data(), length * sizeof(uint32_t));
    }
    return voxels;
}

}  // namespace rubble
