#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rubble {

/// Which keys changed after which version. It keeps the last change of each key, so it grows with the keys and not with
/// the changes, and a question costs what changed since. Keys have an order (operator<) and equality.
template <class Key>
class ChangeLog {
public:
    /// Notes a change. Versions never decrease.
    void add(const Key& key, uint64_t version) {
        m_changes.push_back({version, key});
        if (m_changes.size() > 2 * m_kept + 64) dropOverwritten();
    }
    /// The keys that changed after a version, each once, in their order; replaces `out`.
    void since(uint64_t version, std::vector<Key>& out) const {
        out.clear();
        for (size_t i = m_changes.size(); i-- > 0 && m_changes[i].version > version;) out.push_back(m_changes[i].key);
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
    }
    /// How many changes it holds.
    size_t size() const { return m_changes.size(); }

private:
    struct Change {
        uint64_t version;
        Key key;
    };
    void dropOverwritten() {
        std::stable_sort(m_changes.begin(), m_changes.end(),
                         [](const Change& a, const Change& b) { return a.key < b.key; });
        size_t kept = 0;  // the last of each key
        for (size_t i = 0; i < m_changes.size(); ++i)
            if (i + 1 == m_changes.size() || !(m_changes[i].key == m_changes[i + 1].key))
                m_changes[kept++] = m_changes[i];
        m_changes.erase(m_changes.begin() + ptrdiff_t(kept), m_changes.end());
        std::stable_sort(m_changes.begin(), m_changes.end(),
                         [](const Change& a, const Change& b) { return a.version < b.version; });
        m_kept = kept;
    }

    std::vector<Change> m_changes;  ///< by version, ascending
    size_t m_kept = 0;              ///< by the last dropOverwritten()
};

}  // namespace rubble
