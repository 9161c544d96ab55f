#include "runtime/destruction/run_sets.h"

#include <algorithm>

namespace rubble {

RunSets::RunSets(glm::ivec3 size)
    : m_length(size_t(size.x)),
      m_rowsAPlane(size_t(size.y)),
      m_words((m_length + 63) / 64),
      m_bits(2 * m_rowsAPlane * m_words),
      m_runs(2 * m_rowsAPlane * m_words * 64) {}

void RunSets::add(std::span<const uint64_t> row) {
    const size_t place = m_rows % (2 * m_rowsAPlane), y = m_rows % m_rowsAPlane;
    std::copy(row.begin(), row.end(), m_bits.begin() + ptrdiff_t(place * m_words));
    uint32_t* runs = m_runs.data() + place * m_words * 64;
    forEachRun(row, [&](uint32_t begin, uint32_t end) {
        const uint32_t run = uint32_t(m_sizes.size());
        fillRun(runs, begin, end, run);
        m_sizes.push_back(end - begin);
    });
    m_components += m_sizes.size() - m_sets.size();
    m_sets.grow(m_sizes.size());
    if (y > 0) unite(place, place - 1);
    if (m_rows >= m_rowsAPlane) unite(place, (place + m_rowsAPlane) % (2 * m_rowsAPlane));
    ++m_rows;
}

/// Two runs that touch do so in one stretch: its first cell is enough.
void RunSets::unite(size_t row, size_t other) {
    const uint32_t *runs = m_runs.data() + row * m_words * 64, *others = m_runs.data() + other * m_words * 64;
    uint64_t before = 0;
    for (size_t w = 0; w < m_words; ++w) {
        const uint64_t both = m_bits[row * m_words + w] & m_bits[other * m_words + w];
        for (uint64_t firsts = both & ~(both << 1 | before); firsts; firsts &= firsts - 1) {
            const size_t x = 64 * w + size_t(std::countr_zero(firsts));
            m_components -= m_sets.unite(runs[x], others[x]);
        }
        before = both >> 63;
    }
}

std::vector<uint32_t> RunSets::number(std::vector<uint64_t>& voxels) {
    std::vector<uint32_t> out(m_sizes.size());
    voxels.reserve(m_components);
    for (uint32_t run = 0; run < out.size(); ++run) {
        const uint32_t lower = m_sets.lower(run);  // numbered already
        if (lower == run) voxels.push_back(0);
        out[run] = lower == run ? uint32_t(voxels.size() - 1) : out[lower];
        voxels[out[run]] += m_sizes[run];
    }
    return out;
}

}  // namespace rubble
