#pragma once
#include <glm/vec3.hpp>
#include <type_traits>

#include "runtime/core/fields.h"
#include "runtime/core/hash.h"

namespace rubble {

/// An archive (fields.h) that chains numbers, vectors and structs of them into one hash.
class FieldHash {
public:
    static constexpr bool kIsBinary = true;  ///< it visits all fields
    template <class T>
    void operator()(const char*, const T& value) {
        add(value);
    }
    /// The hash of what was visited until now.
    uint64_t value() const { return m_hash; }

private:
    template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void add(T value) { m_hash = hashValue(value, m_hash); }
    void add(const glm::dvec3& v) { m_hash = hashBytes(&v, sizeof v, m_hash); }
    template <HasFields T>
    void add(const T& value) {
        fields(*this, value);
    }

    uint64_t m_hash = 0;
};

}  // namespace rubble
