#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rubble {

/// Disjoint sets of 0, 1, 2, ..., each named by its lowest member (Tarjan 1975, path halving).
template <class Index = uint32_t>
class UnionFind {
public:
    explicit UnionFind(size_t size = 0) { grow(size); }
    /// Adds members, each a set of its own, until there are this many.
    void grow(size_t size) {
        const size_t before = m_parent.size();
        m_parent.resize(size);
        std::iota(m_parent.begin() + ptrdiff_t(before), m_parent.end(), Index(before));
    }
    size_t size() const { return m_parent.size(); }
    /// The lowest member of the set of i.
    Index root(Index i) {
        while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    /// A member of the set of i that is parent than i; i itself if it is the lowest.
    Index parent(Index i) const { return m_parent[i]; }
    /// False if they were one set already.
    bool unite(Index a, Index b) {
        a = root(a), b = root(b);
        if (a == b) return false;
        m_parent[std::max(a, b)] = std::min(a, b);
        return true;
    }

private:
    std::vector<Index> m_parent;
};

}  // namespace rubble
