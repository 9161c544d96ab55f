#pragma once
#include <cstring>

#include "physics/math/lanes.h"
#include "physics/math/simd4.h"
#if defined(__SSE__) || defined(__AVX2__)
#include <immintrin.h>
#endif

// SIMD: eight lanes at once, in one register where the file is compiled for AVX2, else in two. Every operation is the
// IEEE one of each lane, so the bits are the same. To be included only by files that are compiled for both: the
// namespaces keep the two apart, as the linker would else take one for the other.

namespace rubble {
#ifdef __AVX2__
inline namespace avx2 {
using Part = float __attribute__((vector_size(32)));
using BoolPart = int __attribute__((vector_size(32)));
inline constexpr int kParts = 1;
/// The square root of each lane.
inline Part rootOfPart(Part v) {
    return _mm256_sqrt_ps(v);
}
/// The value in all lanes.
inline Part broadcast(float value) {
    return Part{value, value, value, value, value, value, value, value};
}
#else
inline namespace baseline {
using Part = Float4;
using BoolPart = Bool4;
inline constexpr int kParts = 2;
/// The square root of each lane.
inline Part rootOfPart(Part v) {
#ifdef __SSE__
    return _mm_sqrt_ps(v);
#else
    return Part{__builtin_sqrtf(v[0]), __builtin_sqrtf(v[1]), __builtin_sqrtf(v[2]), __builtin_sqrtf(v[3])};
#endif
}
/// The value in all lanes.
inline Part broadcast(float value) {
    return float4(value);
}
#endif

/// Eight floats in registers.
struct Float8 {
    Float8() = default;
    /// The value in all lanes.
    explicit Float8(float value) {
        for (Part& each : part) each = broadcast(value);
    }
    Part part[kParts];
};
/// Eight results of a comparison.
struct Bool8 {
    BoolPart part[kParts];
};

/// f of each part of the operands.
template <class Result, class F, class... Operands>
inline Result forParts(const F& f, const Operands&... operands) {
    Result result;
    result.part[0] = f(operands.part[0]...);
    if constexpr (kParts == 2) result.part[1] = f(operands.part[1]...);
    return result;
}
inline Float8 operator+(const Float8& a, const Float8& b) {
    return forParts<Float8>([](const Part& p, const Part& q) { return p + q; }, a, b);
}
inline Float8 operator-(const Float8& a, const Float8& b) {
    return forParts<Float8>([](const Part& p, const Part& q) { return p - q; }, a, b);
}
inline Float8 operator*(const Float8& a, const Float8& b) {
    return forParts<Float8>([](const Part& p, const Part& q) { return p * q; }, a, b);
}
inline Float8 operator/(const Float8& a, const Float8& b) {
    return forParts<Float8>([](const Part& p, const Part& q) { return p / q; }, a, b);
}
inline Bool8 operator>(const Float8& a, const Float8& b) {
    return forParts<Bool8>([](const Part& p, const Part& q) { return BoolPart(p > q); }, a, b);
}
inline Bool8 operator&(const Bool8& a, const Bool8& b) {
    return forParts<Bool8>([](const BoolPart& p, const BoolPart& q) { return p & q; }, a, b);
}
/// `yes` where the condition holds, else `no`.
inline Float8 select(const Bool8& condition, const Float8& yes, const Float8& no) {
    return forParts<Float8>([](const BoolPart& c, const Part& p, const Part& q) { return c ? p : q; }, condition, yes,
                            no);
}
/// The larger of each lane; b where one of them is NaN.
inline Float8 larger(const Float8& a, const Float8& b) {
    return forParts<Float8>([](const Part& p, const Part& q) { return p > q ? p : q; }, a, b);
}
/// The smaller of each lane; b where one of them is NaN.
inline Float8 smaller(const Float8& a, const Float8& b) {
    return forParts<Float8>([](const Part& p, const Part& q) { return p < q ? p : q; }, a, b);
}
/// The square root of each lane.
inline Float8 rootOf(const Float8& a) {
    return forParts<Float8>([](const Part& p) { return rootOfPart(p); }, a);
}
/// Reads eight floats.
inline Float8 load(const Lanes& from) {
    Float8 result;
    std::memcpy(&result, from.at, sizeof result);
    return result;
}
/// Writes eight floats.
inline void store(const Float8& from, Lanes& to) {
    std::memcpy(to.at, &from, sizeof from);
}
/// Whether any lane is true.
inline bool any(const Bool8& bools) {
#ifdef __AVX2__
    return _mm256_movemask_ps(reinterpret_cast<__m256>(bools.part[0])) != 0;
#else
    const Bool4 both = bools.part[0] | bools.part[1];
    return (both[0] | both[1] | both[2] | both[3]) != 0;
#endif
}

/// Four columns of eight rows.
struct Columns4 {
    Float8 at[4];
};
/// Transposes four floats of each of eight rows. [rows of any alignment]
inline Columns4 loadRows(const float* const (&rows)[kLanes]) {
    Columns4 out;
#ifdef __AVX2__
    Part r[4];
    for (int i = 0; i < 4; ++i)
        r[i] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(rows[i])), _mm_loadu_ps(rows[i + 4]), 1);
    const Part a = _mm256_unpacklo_ps(r[0], r[1]), b = _mm256_unpackhi_ps(r[0], r[1]),
               c = _mm256_unpacklo_ps(r[2], r[3]), d = _mm256_unpackhi_ps(r[2], r[3]);
    out.at[0].part[0] = _mm256_shuffle_ps(a, c, 0x44);
    out.at[1].part[0] = _mm256_shuffle_ps(a, c, 0xee);
    out.at[2].part[0] = _mm256_shuffle_ps(b, d, 0x44);
    out.at[3].part[0] = _mm256_shuffle_ps(b, d, 0xee);
#else
    for (int half = 0; half < 2; ++half) {
        const float* const* from = rows + 4 * half;
        const Float4 r0 = rubble::load(from[0]), r1 = rubble::load(from[1]), r2 = rubble::load(from[2]),
                     r3 = rubble::load(from[3]);
        const Float4 a = __builtin_shufflevector(r0, r1, 0, 4, 1, 5), b = __builtin_shufflevector(r0, r1, 2, 6, 3, 7),
                     c = __builtin_shufflevector(r2, r3, 0, 4, 1, 5), d = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
        out.at[0].part[half] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
        out.at[1].part[half] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
        out.at[2].part[half] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
        out.at[3].part[half] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
    }
#endif
    return out;
}
/// Writes the rows back; a null row is left out.
inline void storeRows(const Columns4& columns, float* const (&rows)[kLanes]) {
    for (int half = 0; half < 2; ++half) {
        Float4 c[4];
        for (int i = 0; i < 4; ++i) std::memcpy(&c[i], reinterpret_cast<const char*>(&columns.at[i]) + 16 * half, 16);
        const Float4 a = __builtin_shufflevector(c[0], c[1], 0, 4, 1, 5),
                     b = __builtin_shufflevector(c[0], c[1], 2, 6, 3, 7),
                     d = __builtin_shufflevector(c[2], c[3], 0, 4, 1, 5),
                     e = __builtin_shufflevector(c[2], c[3], 2, 6, 3, 7);
        const Float4 r[4] = {__builtin_shufflevector(a, d, 0, 1, 4, 5), __builtin_shufflevector(a, d, 2, 3, 6, 7),
                             __builtin_shufflevector(b, e, 0, 1, 4, 5), __builtin_shufflevector(b, e, 2, 3, 6, 7)};
        for (int i = 0; i < 4; ++i)
            if (float* row = rows[4 * half + i]) std::memcpy(row, &r[i], sizeof r[i]);
    }
}

}  // namespace baseline or avx2
}  // namespace rubble
