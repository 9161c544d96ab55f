#pragma once
#include <charconv>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace rubble {

/// What lights, joints and supplies of a level call an object that has no name, or not as the first: "#3" for the third
/// one of all.
inline std::string numberReference(size_t number) {
    return "#" + std::to_string(number);
}

/// Finds objects of a level by what others of it call them: a name, of several the first, or a number. Value() is none.
template <class Value>
class References {
public:
    /// The next object of the level; Value(): it is left out.
    void add(const std::string& name, Value object) {
        m_objects.push_back(object);
        if (object != Value{} && !name.empty()) m_named.emplace(name, object);
    }
    /// Value() if there is none.
    Value find(const std::string& reference) const {
        if (const auto named = m_named.find(reference); named != m_named.end()) return named->second;
        size_t number = 0;
        const char* const end = reference.data() + reference.size();
        if (!reference.starts_with('#') || std::from_chars(reference.data() + 1, end, number).ptr != end) return {};
        return number && number <= m_objects.size() ? m_objects[number - 1] : Value{};
    }

private:
    std::vector<Value> m_objects;
    std::unordered_map<std::string, Value> m_named;
};

}  // namespace rubble
