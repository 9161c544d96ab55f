#pragma once
#include <cstdint>
#include <map>
#include <vector>

namespace rubble {

/// Hands out numbers, lowest unused first among those never used, last freed first otherwise.
class IndexAllocator {
public:
    uint32_t take() {
        if (m_free.empty()) return m_end++;
        const uint32_t slot = m_free.back();
        m_free.pop_back();
        return slot;
    }
    void give(uint32_t slot) { m_free.push_back(slot); }
    /// One more than the highest number ever handed out.
    uint32_t end() const { return m_end; }
    uint32_t used() const { return m_end - uint32_t(m_free.size()); }

private:
    std::vector<uint32_t> m_free;
    uint32_t m_end = 0;
};

/// Hands out ranges of numbers: the first gap that is long enough.
class RangeAllocator {
public:
    uint32_t take(uint32_t count) {
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
    void give(uint32_t start, uint32_t count) {
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
    uint32_t end() const { return m_end; }

private:
    std::map<uint32_t, uint32_t> m_gaps;  ///< start -> length
    uint32_t m_end = 0;
};

}  // namespace rubble
