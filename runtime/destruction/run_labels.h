#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "runtime/core/union_find.h"

namespace rubble {

/// Calls f(begin, end) for every run of set bits in a row of words, end excluded; the last word holds no bits beyond
/// the row.
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

/// How far fillRun() may write beyond its end.
inline constexpr size_t kFillPadding = 4;
/// Fills out[begin, end), four at a time and at least once: most runs are short, and a store costs less than a
/// question.
inline void fillRun(uint32_t* out, uint32_t begin, uint32_t end, uint32_t value) {
    const uint64_t two = value * 0x0000000100000001ull, four[2] = {two, two};
    do {
        std::memcpy(out + begin, four, 16);
        begin += 4;
    } while (begin < end);
}

/// 6-connected components of cells that come as rows of bits along x. A run takes the label of one that it touches in
/// the row before or in the plane below, or else a new one; labels that meet are united (He, Chao & Suzuki 2008, in
/// three dimensions). Keeps two planes, twelve bytes a label, and four bytes a run if they are asked for.
class RunLabels {
public:
    RunLabels(glm::ivec3 size, bool keepsRuns);
    size_t wordsPerRow() const { return m_words; }
    /// The next row, by y, then z.
    void add(std::span<const uint64_t> row);
    /// Once, after all rows: the voxels of each component, components ordered by their first cell.
    std::vector<uint64_t> countComponents();
    /// After that, if runs are kept: the number of each run's component.
    std::span<const uint32_t> runs() const { return std::span(m_labelOf).first(m_runs); }

private:
    void reserveRow();

    size_t m_length, m_rowsPerPlane, m_words;
    bool m_keepsRuns;
    size_t m_rows = 0;                ///< that have come
    uint32_t m_labels = 0;            ///< given
    size_t m_runs = 0;                ///< that have come
    std::vector<uint64_t> m_bits;     ///< of two planes, in turns
    std::vector<uint32_t> m_cells;    ///< the same: the label of a solid cell
    std::vector<uint64_t> m_sizes;    ///< by label, with room for a row of new ones
    UnionFind<> m_sets;               ///< the same
    std::vector<uint32_t> m_labelOf;  ///< by run, with room for a row of them
};

}  // namespace rubble
