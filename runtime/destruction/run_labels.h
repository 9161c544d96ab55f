#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "runtime/core/union_find.h"

namespace rubble {

/// Calls f(begin, end) for every run of set bits in a row of words; `end` is not part of the run. Bits of the last word
/// beyond the row must be zero.
template <class F>
void forEachRun(std::span<const uint64_t> row, F&& f) {
    constexpr uint32_t kNone = ~0u;
    uint64_t before = 0;
    uint32_t begin = kNone;
    for (size_t w = 0; w < row.size(); ++w) {
        for (uint64_t edges = row[w] ^ (row[w] << 1 | before); edges; edges &= edges - 1) {
            const uint32_t x = uint32_t(64 * w) + uint32_t(std::countr_zero(edges));
            if (begin != kNone) f(begin, x);
            begin = begin == kNone ? x : kNone;
        }
        before = row[w] >> 63;
    }
    if (begin != kNone) f(begin, uint32_t(64 * row.size()));
}

inline constexpr size_t kFillPadding = 4;  ///< elements that fillRun() may write beyond its end
/// Fills out[begin, end), four elements at a time and at least once, and may write up to kFillPadding elements beyond
/// the end: most runs are short, and a store costs less than a branch that is predicted badly.
inline void fillRun(uint32_t* out, uint32_t begin, uint32_t end, uint32_t value) {
    const uint64_t two = value * 0x0000000100000001ull, four[2] = {two, two};
    do {
        std::memcpy(out + begin, four, 16);
        begin += 4;
    } while (begin < end);
}

/// Connected component labelling by runs; the algorithm is at the top of run_labels.cpp. Memory: two planes of bits and
/// labels, twelve bytes for each label, and four bytes for each run if runs are kept.
class RunLabels {
public:
    /// For a volume of `size` cells. keepsRuns: whether runs() will be asked for.
    RunLabels(glm::ivec3 size, bool keepsRuns);
    /// 64-bit words of one row along x.
    size_t wordsPerRow() const { return m_words; }
    /// Labels the next row of bits; rows come by y, then z.
    void add(std::span<const uint64_t> row);
    /// Once, after all rows: the cells of each component, components ordered by their first cell.
    std::vector<uint64_t> countComponents();
    /// The component of each run, in the order of the runs. After countComponents(), if runs are kept.
    std::span<const uint32_t> runs() const { return std::span(m_labelOf).first(m_runs); }

private:
    void reserveRow();

    size_t m_length, m_rowsPerPlane, m_words;
    bool m_keepsRuns;
    size_t m_rows = 0;                ///< rows added
    uint32_t m_labels = 0;            ///< labels given
    size_t m_runs = 0;                ///< runs in the rows added
    std::vector<uint64_t> m_bits;     ///< the last two planes, and one empty row
    std::vector<uint32_t> m_cells;    ///< the labels of their solid cells
    std::vector<uint64_t> m_sizes;    ///< cells by label, with space for the labels of one more row
    UnionFind<> m_sets;               ///< of labels, of the same size
    std::vector<uint32_t> m_labelOf;  ///< label by run, with space for one more row
};

}  // namespace rubble
