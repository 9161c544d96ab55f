#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "runtime/core/union_find.h"

namespace rubble {

/// Calls f(begin, end) for every run of set bits in a row of words, end excluded; the last word holds no bits beyond the row.
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

/// Fills out[begin, end), two at a time: most runs are short, and some very long.
inline void fillRun(uint32_t* out, uint32_t begin, uint32_t end, uint32_t value) {
    const uint64_t two = value * 0x0000000100000001ull;
    for (; begin + 2 <= end; begin += 2) std::memcpy(out + begin, &two, 8);
    if (begin < end) out[begin] = value;
}

/// 6-connected components of cells that come as rows of bits along x: of runs, united where they touch one of the row before or
/// of the plane below (He, Chao & Suzuki 2008, in three dimensions). Keeps two planes, and twelve bytes a run.
class RunSets {
public:
    explicit RunSets(glm::ivec3 size);
    size_t wordsARow() const { return m_words; }
    /// The next row, by y, then z.
    void add(std::span<const uint64_t> row);
    /// After all rows: the number of each run's component, by run, components ordered by their first cell; adds up the voxels
    /// of each.
    std::vector<uint32_t> number(std::vector<uint64_t>& voxels);

private:
    void unite(size_t row, size_t other);

    size_t m_length, m_rowsAPlane, m_words;
    size_t m_rows = 0;              ///< that have come
    size_t m_components = 0;        ///< of them, so far
    std::vector<uint64_t> m_bits;   ///< of two planes, in turns
    std::vector<uint32_t> m_runs;   ///< the same: which run a solid cell belongs to
    std::vector<uint32_t> m_sizes;  ///< by run
    UnionFind<> m_sets;
};

}  // namespace rubble
