#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rubble {

/// Disjoint sets of 0, 1, 2, ..., each represented by its lowest member. Path halving: R. Tarjan and J. van Leeuwen,
/// "Worst-case analysis of set union algorithms", JACM 31 (1984). Lowest-member roots make results independent of the
/// order of unite().
template <class Index = uint32_t>
class UnionFind {
public:
    /// `size` members, each a set of its own.
    explicit UnionFind(size_t size = 0) { grow(size); }
    /// Adds members, each a set of its own, until there are `size`.
    void grow(size_t size) {
        const size_t before = m_parent.size();
        m_parent.resize(size);
        std::iota(m_parent.begin() + ptrdiff_t(before), m_parent.end(), Index(before));
    }
    /// Members of all sets.
    size_t size() const { return m_parent.size(); }
    /// The lowest member of the set of i. Shortens the path to it.
    Index root(Index i) {
        while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    /// The next member on the path from i to its root: lower than i, or i itself if it is the root.
    Index parent(Index i) const { return m_parent[i]; }
    /// Unites the sets of a and b. False if they were one set already.
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
