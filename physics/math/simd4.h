#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <glm/mat3x3.hpp>

namespace rubble {

/// Float4 toFloat4 that are worked on at once, and float4 truths (-1 or 0).
using Float4 = float __attribute__((vector_size(16)));
using Bool4 = int __attribute__((vector_size(16)));
using Int4 = Bool4;

inline Float4 load(const float* from) {
    Float4 float4;
    std::memcpy(&float4, from, sizeof float4);
    return float4;
}
/// Float4 bytes as numbers.
inline Int4 load(const std::array<uint8_t, 4>& from) {
    using Byte4 = uint8_t __attribute__((vector_size(4)));
    Byte4 bytes;
    std::memcpy(&bytes, from.data(), sizeof bytes);
    return __builtin_convertvector(bytes, Int4);
}
inline Float4 toFloat4(Int4 v) {
    return __builtin_convertvector(v, Float4);
}
inline Float4 float4(float value) {
    return Float4{value, value, value, value};
}
inline Float4 min4(Float4 a, Float4 b) {
    return a < b ? a : b;
}
inline Float4 max4(Float4 a, Float4 b) {
    return a > b ? a : b;
}
inline Int4 min4(Int4 a, Int4 b) {
    return a < b ? a : b;
}
inline Int4 max4(Int4 a, Int4 b) {
    return a > b ? a : b;
}
/// Rounds down.
inline Int4 floorOf(Float4 v) {
    const Int4 i = __builtin_convertvector(v, Int4);
    return i + (__builtin_convertvector(i, Float4) > v);
}
inline bool any(Bool4 bools) {
    std::array<uint64_t, 2> words;
    std::memcpy(words.data(), &bools, sizeof bools);
    return (words[0] | words[1]) != 0;
}

/// A vector in the first three, 0 in the last.
inline Float4 float4(const glm::vec3& v) {
    return Float4{v.x, v.y, v.z, 0.0f};
}
inline glm::vec3 vec3(Float4 v) {
    return {v[0], v[1], v[2]};
}
inline float dot(Float4 a, Float4 b) {
    const Float4 product = a * b;
    return product[0] + product[1] + product[2];
}
inline Float4 cross(Float4 a, Float4 b) {
    const Float4 turned = a * __builtin_shufflevector(b, b, 1, 2, 0, 3) - __builtin_shufflevector(a, a, 1, 2, 0, 3) * b;
    return __builtin_shufflevector(turned, turned, 1, 2, 0, 3);
}

/// A matrix of columns of float4.
struct SimdMat3 {
    SimdMat3(const glm::mat3& m) : x(float4(m[0])), y(float4(m[1])), z(float4(m[2])) {}
    Float4 operator*(Float4 v) const { return x * float4(v[0]) + y * float4(v[1]) + z * float4(v[2]); }
    Float4 x, y, z;
};

}  // namespace rubble
