#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/core/assertion.h"

namespace rubble {

/// A map from keys to indices in one array that clear() keeps: open addressing with linear probing (D. Knuth, The Art
/// of Computer Programming 3, 6.4). It is looked up, never iterated.
class IndexMap {
public:
    static constexpr uint32_t kNone = ~0u;

    /// The index of a key; kNone if it has none.
    uint32_t find(uint64_t key) const { return m_cells.empty() ? kNone : m_cells[cellOf(key)].index; }
    /// The index of a key, to be changed; kNone at first. Valid until the next call for another key.
    uint32_t& operator[](uint64_t key) {
        RUBBLE_ASSERT(key != kEmpty);
        if (2 * (m_size + 1) > m_cells.size()) grow();
        Cell& cell = m_cells[cellOf(key)];
        if (cell.key == kEmpty) cell.key = key, ++m_size;
        return cell.index;
    }
    /// Removes all keys.
    void clear() {
        if (m_size) std::fill(m_cells.begin(), m_cells.end(), Cell{});
        m_size = 0;
    }

private:
    static constexpr uint64_t kEmpty = ~uint64_t(0);
    struct Cell {
        uint64_t key = kEmpty;
        uint32_t index = kNone;
    };

    /// Where a key is, or the free cell where it would be.
    size_t cellOf(uint64_t key) const {
        size_t at = size_t(key * 0x9e3779b97f4a7c15u >> 32) & (m_cells.size() - 1);
        while (m_cells[at].key != key && m_cells[at].key != kEmpty) at = (at + 1) & (m_cells.size() - 1);
        return at;
    }
    void grow() {
        std::vector<Cell> old(std::max<size_t>(16, 2 * m_cells.size()));
        old.swap(m_cells);
        for (const Cell& cell : old)
            if (cell.key != kEmpty) m_cells[cellOf(cell.key)] = cell;
    }

    std::vector<Cell> m_cells;  ///< a power of two of them, at most half of them used
    size_t m_size = 0;
};

}  // namespace rubble
