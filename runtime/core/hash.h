#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace rubble {

/// XXH3, 64 bits (xxhash.com). The same on every machine. Chain several by passing the last hash as `seed`.
uint64_t hashBytes(const void* data, size_t size, uint64_t seed = 0);

/// The hash of a value's bytes. For types without padding and for floating-point numbers, of which 0.0 and -0.0 differ.
template <class T>
uint64_t hashValue(const T& value, uint64_t seed = 0) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>,
                  "padding would be hashed");
    return hashBytes(&value, sizeof value, seed);
}

}  // namespace rubble
