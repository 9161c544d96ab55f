#pragma once
#include <cstdint>
#include <map>
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

/// Allocates ranges of indices: the first free range that is long enough, or else one at the end. Freed neighbours
/// merge.
class RangeAllocator {
public:
    /// The first index of `count` that are not in use.
    uint32_t allocate(uint32_t count) {
        for (auto gap = m_gaps.begin(); gap != m_gaps.end(); ++gap) {
            if (gap->second < count) continue;
            const auto [start, length] = *gap;
            m_gaps.erase(gap);
            if (length > count) m_gaps[start + count] = length - count;
            return start;
        }
        const uint32_t start = m_end;
        m_end += count;
        return start;
    }
    /// Gives an allocated range back.
    void free(uint32_t start, uint32_t count) {
        auto after = m_gaps.upper_bound(start);
        if (after != m_gaps.end() && after->first == start + count) {
            count += after->second;
            after = m_gaps.erase(after);
        }
        if (after != m_gaps.begin()) {
            const auto before = std::prev(after);
            if (before->first + before->second == start) {
                before->second += count;
                return;
            }
        }
        m_gaps[start] = count;
    }
    /// One more than the highest index ever allocated.
    uint32_t end() const { return m_end; }

private:
    std::map<uint32_t, uint32_t> m_gaps;  ///< start -> length
    uint32_t m_end = 0;
};

}  // namespace rubble
