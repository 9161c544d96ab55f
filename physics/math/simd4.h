#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <glm/mat3x3.hpp>
#ifdef __SSE4_1__
#include <smmintrin.h>
#elif defined __SSE__
#include <xmmintrin.h>
#endif

// SIMD: four lanes at once, by the vector extensions of gcc and clang. Every operation is the IEEE one of each lane, so
// results do not depend on how wide the machine's registers are.

namespace rubble {

using Float4 = float __attribute__((vector_size(16)));
using Bool4 = int __attribute__((vector_size(16)));  ///< -1 for true, 0 for false: the result of a comparison
using Int4 = Bool4;

/// Loads four floats from memory of any alignment.
inline Float4 load(const float* from) {
    Float4 lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
/// Loads four bytes, widened to integers.
inline Int4 load(const std::array<uint8_t, 4>& from) {
#ifdef __SSE4_1__
    int bytes;
    std::memcpy(&bytes, from.data(), sizeof bytes);
    return Int4(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(bytes)));
#else
    return Int4{from[0], from[1], from[2], from[3]};
#endif
}
/// Converts each lane.
inline Float4 toFloat4(Int4 v) {
    return __builtin_convertvector(v, Float4);
}
/// The value in all lanes.
inline Float4 float4(float value) {
    return Float4{value, value, value, value};
}
/// The smaller of each lane; b where one of them is NaN.
inline Float4 min4(Float4 a, Float4 b) {
    return a < b ? a : b;
}
/// The larger of each lane; b where one of them is NaN.
inline Float4 max4(Float4 a, Float4 b) {
    return a > b ? a : b;
}
/// The smaller of each lane.
inline Int4 min4(Int4 a, Int4 b) {
    return a < b ? a : b;
}
/// The larger of each lane.
inline Int4 max4(Int4 a, Int4 b) {
    return a > b ? a : b;
}
/// Rounds each lane down.
inline Int4 floorOf(Float4 v) {
    const Int4 i = __builtin_convertvector(v, Int4);
    return i + (__builtin_convertvector(i, Float4) > v);
}
/// The absolute value of each lane.
inline Float4 abs4(Float4 v) {
    return max4(v, -v);
}
/// Four vectors, given by their x, y and z: lane i of each belongs to vector i. 0 in the last lane of each.
inline std::array<Float4, 4> transposed(Float4 x, Float4 y, Float4 z) {
    const Float4 none{},
        xyLow = __builtin_shufflevector(x, y, 0, 4, 1, 5), xyHigh = __builtin_shufflevector(x, y, 2, 6, 3, 7),
        zLow = __builtin_shufflevector(z, none, 0, 4, 1, 5), zHigh = __builtin_shufflevector(z, none, 2, 6, 3, 7);
    return {__builtin_shufflevector(xyLow, zLow, 0, 1, 4, 5), __builtin_shufflevector(xyLow, zLow, 2, 3, 6, 7),
            __builtin_shufflevector(xyHigh, zHigh, 0, 1, 4, 5), __builtin_shufflevector(xyHigh, zHigh, 2, 3, 6, 7)};
}
/// The x, y and z of four vectors.
inline std::array<Float4, 3> transposed(const std::array<Float4, 4>& v) {
    const Float4 low01 = __builtin_shufflevector(v[0], v[1], 0, 4, 1, 5),
                 low23 = __builtin_shufflevector(v[2], v[3], 0, 4, 1, 5),
                 high01 = __builtin_shufflevector(v[0], v[1], 2, 6, 3, 7),
                 high23 = __builtin_shufflevector(v[2], v[3], 2, 6, 3, 7);
    return {__builtin_shufflevector(low01, low23, 0, 1, 4, 5), __builtin_shufflevector(low01, low23, 2, 3, 6, 7),
            __builtin_shufflevector(high01, high23, 0, 1, 4, 5)};
}
/// Whether any lane is true.
inline bool any(Bool4 bools) {
    std::array<uint64_t, 2> words;
    std::memcpy(words.data(), &bools, sizeof bools);
    return (words[0] | words[1]) != 0;
}

/// Bit i: lane i is true.
inline uint32_t bitsOf(Bool4 bools) {
#ifdef __SSE__
    return uint32_t(_mm_movemask_ps(Float4(bools)));
#else
    return uint32_t((bools[0] & 1) | (bools[1] & 2) | (bools[2] & 4) | (bools[3] & 8));
#endif
}

/// A vector in the first three lanes, 0 in the last.
inline Float4 float4(const glm::vec3& v) {
    return Float4{v.x, v.y, v.z, 0.0f};
}
/// The first three lanes.
inline glm::vec3 vec3(Float4 v) {
    return {v[0], v[1], v[2]};
}
/// The dot product of the first three lanes, summed from x to z.
inline float dot(Float4 a, Float4 b) {
    const Float4 product = a * b;
    return product[0] + product[1] + product[2];
}
/// The cross product of the first three lanes; 0 in the last.
inline Float4 cross(Float4 a, Float4 b) {
    const Float4 rotated =
        a * __builtin_shufflevector(b, b, 1, 2, 0, 3) - __builtin_shufflevector(a, a, 1, 2, 0, 3) * b;
    return __builtin_shufflevector(rotated, rotated, 1, 2, 0, 3);
}

/// A 3 x 3 matrix as three columns.
struct SimdMat3 {
    /// Columns as in glm.
    SimdMat3(const glm::mat3& m) : x(float4(m[0])), y(float4(m[1])), z(float4(m[2])) {}
    Float4 operator*(Float4 v) const { return x * float4(v[0]) + y * float4(v[1]) + z * float4(v[2]); }
    Float4 x, y, z;
};

}  // namespace rubble
