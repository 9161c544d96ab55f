#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace rubble {

/// Allocates indices: the one that was freed last, or else the lowest that was never used.
class IndexAllocator {
public:
    /// An index that is not in use.
    uint32_t allocate() {
        if (m_free.empty()) return m_end++;
        const uint32_t index = m_free.back();
        m_free.pop_back();
        return index;
    }
    /// Gives an allocated index back.
    void free(uint32_t index) { m_free.push_back(index); }
    /// One more than the highest index ever allocated.
    uint32_t end() const { return m_end; }
    /// Number of indices in use.
    uint32_t used() const { return m_end - uint32_t(m_free.size()); }

private:
    std::vector<uint32_t> m_free;
    uint32_t m_end = 0;
};

/// Allocates ranges of indices: the shortest free range that is long enough (best fit), the lowest of these, or else
/// one at the end. Freed neighbours merge. Both take the logarithm of the number of free ranges.
class RangeAllocator {
public:
    /// The first index of `count` that are not in use.
    uint32_t allocate(uint32_t count) {
        const auto fit = m_byLength.lower_bound({count, 0});
        if (fit == m_byLength.end()) return std::exchange(m_end, m_end + count);
        const auto [length, start] = *fit;
        removeGap(start, length);
        if (length > count) addGap(start + count, length - count);
        return start;
    }
    /// Gives an allocated range back.
    void free(uint32_t start, uint32_t count) {
        const auto after = m_gaps.lower_bound(start);
        if (after != m_gaps.begin()) {
            const auto [first, length] = *std::prev(after);
            if (first + length == start) {
                removeGap(first, length);
                start = first;
                count += length;
            }
        }
        if (after != m_gaps.end() && after->first == start + count) {
            const uint32_t length = after->second;
            removeGap(after->first, length);
            count += length;
        }
        addGap(start, count);
    }
    /// One more than the highest index ever allocated.
    uint32_t end() const { return m_end; }

private:
    void addGap(uint32_t start, uint32_t length) {
        m_gaps[start] = length;
        m_byLength.insert({length, start});
    }
    void removeGap(uint32_t start, uint32_t length) {
        m_gaps.erase(start);
        m_byLength.erase({length, start});
    }

    std::map<uint32_t, uint32_t> m_gaps;                 ///< start -> length
    std::set<std::pair<uint32_t, uint32_t>> m_byLength;  ///< the same: length, start
    uint32_t m_end = 0;
};

}  // namespace rubble
