#include "runtime/destruction/run_labels.h"

#include <algorithm>
#include <utility>

// Run-based two-scan labelling (L. He, Y. Chao and K. Suzuki, "A run-based two-scan labeling algorithm", IEEE Trans.
// Image Processing 17, 2008), extended from four neighbours in a plane to six in a volume.
//
// A run is a maximal row of solid cells along x. The first scan gives each run the label of a run that it touches in
// the row before or in the plane below, or a new label if it touches none. Where it touches runs of other labels, these
// labels are united (union-find). Two runs touch where the AND of their rows has a bit; the first bit of each run of
// that AND stands for the whole contact. The second scan maps each label to the number of its set. Roots are lowest
// labels, so components are numbered in the order of their first cells.

namespace rubble {
namespace {

/// The first bit of every run of bits. `before`: whether the bit below the lowest is set.
uint64_t firstBits(uint64_t bits, uint64_t before) {
    return bits & ~(bits << 1 | before);
}

/// `a` if the lowest bit is set, else `b`, without a branch: in noise it would be predicted badly.
uint32_t choose(uint64_t bit, uint32_t a, uint32_t b) {
    return b ^ ((a ^ b) & (0 - uint32_t(bit & 1)));
}

}  // namespace

// The row after the two planes stays empty: it is the neighbour of rows at the border of the volume.
RunLabels::RunLabels(glm::ivec3 size, bool keepsRuns)
    : m_length(size_t(size.x)),
      m_rowsPerPlane(size_t(size.y)),
      m_words((m_length + 63) / 64),
      m_keepsRuns(keepsRuns),
      m_bits((2 * m_rowsPerPlane + 1) * m_words),
      m_cells((2 * m_rowsPerPlane + 1) * m_words * 64 + kFillPadding) {}

/// Makes space for the labels and runs of one more row, of which at most every other cell begins one.
void RunLabels::reserveRow() {
    const auto enough = [&](size_t have, size_t used) { return have >= used + m_length / 2 + 1; };
    const auto more = [&](size_t have) { return 2 * have + 64 * m_length; };
    if (!enough(m_sizes.size(), m_labels)) {
        m_sizes.resize(more(m_sizes.size()));
        m_sets.grow(m_sizes.size());
    }
    if (m_keepsRuns && !enough(m_labelOf.size(), m_runs)) m_labelOf.resize(more(m_labelOf.size()));
}

void RunLabels::add(std::span<const uint64_t> row) {
    reserveRow();
    const size_t outside = 2 * m_rowsPerPlane, place = m_rows % outside;
    const size_t before = m_rows % m_rowsPerPlane > 0 ? place - 1 : outside;
    const size_t below = m_rows >= m_rowsPerPlane ? (place + m_rowsPerPlane) % outside : outside;
    const uint64_t *bitsBefore = m_bits.data() + before * m_words, *bitsBelow = m_bits.data() + below * m_words;
    const uint32_t *cellsBefore = m_cells.data() + before * m_words * 64,
                   *cellsBelow = m_cells.data() + below * m_words * 64;
    uint32_t* cells = m_cells.data() + place * m_words * 64;
    uint64_t last = 0, lastBefore = 0, lastBelow = 0;  // bit 63 of the last word, alone and in the ANDs
    uint32_t label = 0, labels = m_labels, *labelOf = m_keepsRuns ? m_labelOf.data() : nullptr;
    uint64_t* sizes = m_sizes.data();
    size_t runs = m_runs;
    for (size_t w = 0; w < m_words; ++w) {
        const uint64_t bits = row[w], withBefore = bits & bitsBefore[w], withBelow = bits & bitsBelow[w];
        const uint64_t firsts = firstBits(bits, last);
        if (bits & last) {
            const uint32_t length = uint32_t(std::countr_one(bits));
            fillRun(cells, uint32_t(64 * w), uint32_t(64 * w) + length, label);
            sizes[label] += length;
        }
        for (uint64_t left = firsts; left; left &= left - 1) {
            const int bit = std::countr_zero(left);
            const uint32_t x = uint32_t(64 * w) + uint32_t(bit), length = uint32_t(std::countr_one(bits >> bit));
            label = choose(withBefore >> bit, cellsBefore[x], choose(withBelow >> bit, cellsBelow[x], labels));
            labels += label == labels;
            fillRun(cells, x, x + length, label);
            sizes[label] += length;
            if (labelOf) labelOf[runs++] = label;
        }
        const auto meet = [&](uint64_t where, const uint32_t* others) {
            for (; where; where &= where - 1) {
                const size_t x = 64 * w + size_t(std::countr_zero(where));
                if (cells[x] != others[x]) m_sets.unite(cells[x], others[x]);
            }
        };
        meet(firstBits(withBefore, lastBefore) & ~firsts, cellsBefore);
        meet(firstBits(withBelow, lastBelow) & ~(firsts & ~withBefore), cellsBelow);
        last = bits >> 63, lastBefore = withBefore >> 63, lastBelow = withBelow >> 63;
    }
    std::copy(row.begin(), row.end(), m_bits.begin() + ptrdiff_t(place * m_words));
    m_labels = labels, m_runs = runs;
    ++m_rows;
}

std::vector<uint64_t> RunLabels::countComponents() {
    std::vector<uint32_t> numbers(m_labels);
    uint32_t components = 0;
    for (uint32_t label = 0; label < m_labels; ++label) {
        const uint32_t parent = m_sets.parent(label), number = parent == label ? components : numbers[parent];
        components += parent == label;
        numbers[label] = number;
        const uint64_t size = std::exchange(m_sizes[label], 0);
        m_sizes[number] += size;  // number <= label: that label's own size has been read
    }
    for (size_t run = 0; run < m_runs; ++run) m_labelOf[run] = numbers[m_labelOf[run]];
    m_sizes.resize(components);
    return std::move(m_sizes);
}

}  // namespace rubble
