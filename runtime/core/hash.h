#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace rubble {

/// XXH3, 64 bits (xxhash.com).
uint64_t hashBytes(const void* data, size_t size, uint64_t seed = 0);

template <class T>
uint64_t hashValue(const T& value, uint64_t seed = 0) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>,
                  "padding would be hashed");
    return hashBytes(&value, sizeof value, seed);
}

}  // namespace rubble
