#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <glm/mat3x3.hpp>

namespace rubble {

/// Four floats that are worked on at once, and four truths (-1 or 0).
using Four = float __attribute__((vector_size(16)));
using FourBools = int __attribute__((vector_size(16)));
using FourInts = FourBools;

inline Four load(const float* from) {
    Four four;
    std::memcpy(&four, from, sizeof four);
    return four;
}
/// Four bytes as numbers.
inline FourInts load(const std::array<uint8_t, 4>& from) {
    using FourBytes = uint8_t __attribute__((vector_size(4)));
    FourBytes bytes;
    std::memcpy(&bytes, from.data(), sizeof bytes);
    return __builtin_convertvector(bytes, FourInts);
}
inline Four floats(FourInts v) {
    return __builtin_convertvector(v, Four);
}
inline Four four(float value) {
    return Four{value, value, value, value};
}
inline Four smaller(Four a, Four b) {
    return a < b ? a : b;
}
inline Four larger(Four a, Four b) {
    return a > b ? a : b;
}
inline FourInts smaller(FourInts a, FourInts b) {
    return a < b ? a : b;
}
inline FourInts larger(FourInts a, FourInts b) {
    return a > b ? a : b;
}
/// Rounds down.
inline FourInts floorOf(Four v) {
    const FourInts i = __builtin_convertvector(v, FourInts);
    return i + (__builtin_convertvector(i, Four) > v);
}
inline bool any(FourBools bools) {
    std::array<uint64_t, 2> words;
    std::memcpy(words.data(), &bools, sizeof bools);
    return (words[0] | words[1]) != 0;
}

/// A vector in the first three, 0 in the last.
inline Four four(const glm::vec3& v) {
    return Four{v.x, v.y, v.z, 0.0f};
}
inline glm::vec3 vec3(Four v) {
    return {v[0], v[1], v[2]};
}
inline float dot(Four a, Four b) {
    const Four product = a * b;
    return product[0] + product[1] + product[2];
}
inline Four cross(Four a, Four b) {
    const Four turned = a * __builtin_shufflevector(b, b, 1, 2, 0, 3) - __builtin_shufflevector(a, a, 1, 2, 0, 3) * b;
    return __builtin_shufflevector(turned, turned, 1, 2, 0, 3);
}

/// A matrix of columns of four.
struct FourColumns {
    FourColumns(const glm::mat3& m) : x(four(m[0])), y(four(m[1])), z(four(m[2])) {}
    Four operator*(Four v) const { return x * four(v[0]) + y * four(v[1]) + z * four(v[2]); }
    Four x, y, z;
};

}  // namespace rubble
