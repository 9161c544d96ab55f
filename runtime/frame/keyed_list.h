#pragma once
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rubble {

/// Values in a list, each found by a key that keyOf(value) tells. The index is made when something is first looked up:
/// a list that is only handed on costs a move.
template <class Value, class Key, class Hash, Key (*keyOf)(const Value&)>
class KeyedList {
public:
    KeyedList() = default;
    /// Takes values with keys that differ.
    explicit KeyedList(std::vector<Value>&& values) : m_values(std::move(values)) {}

    /// The value of a key; null if there is none. Valid until the list changes.
    Value* find(const Key& key) {
        const auto place = index().find(key);
        return place == m_index.end() ? nullptr : &m_values[place->second];
    }
    /// Adds a value behind the others, or puts it in the place of the one with its key. Valid until the list changes.
    Value& set(Value&& value) {
        const auto [place, isNew] = index().try_emplace(keyOf(value), m_values.size());
        if (!isNew) return m_values[place->second] = std::move(value);
        return m_values.emplace_back(std::move(value));
    }
    /// Removes the value of a key, if there is one; the last one gets its place.
    void erase(const Key& key) {
        const auto place = index().find(key);
        if (place == m_index.end()) return;
        const size_t at = place->second;
        m_index.erase(place);
        if (at + 1 < m_values.size()) {
            m_values[at] = std::move(m_values.back());
            m_index[keyOf(m_values[at])] = at;
        }
        m_values.pop_back();
    }
    /// Removes all values and returns them.
    std::vector<Value> take() {
        m_index.clear();
        m_isIndexed = false;
        return std::exchange(m_values, {});
    }
    /// No value.
    bool empty() const { return m_values.empty(); }

private:
    using Index = std::unordered_map<Key, size_t, Hash>;
    Index& index() {
        if (m_isIndexed) return m_index;
        m_isIndexed = true;
        m_index.reserve(m_values.size());
        for (size_t i = 0; i < m_values.size(); ++i) m_index.emplace(keyOf(m_values[i]), i);
        return m_index;
    }
    std::vector<Value> m_values;
    Index m_index;
    bool m_isIndexed = false;
};

}  // namespace rubble
