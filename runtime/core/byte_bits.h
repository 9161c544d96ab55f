#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace rubble {

// Tests of many bytes at once. Byte i of an array is bit i of the result; byte 0 is the lowest byte of a word.
static_assert(std::endian::native == std::endian::little, "loadBytes() reads the first byte as the lowest");

inline constexpr uint64_t kByteOnes = 0x0101010101010101ull;  ///< 1 in every byte

/// 1 in every byte that is not zero, 0 in the others (H. Warren, Hacker's Delight, 6-1).
constexpr uint64_t nonZeroBytes(uint64_t bytes) {
    return (((bytes & 0x7f * kByteOnes) + 0x7f * kByteOnes) | bytes) >> 7 & kByteOnes;
}
/// Eight bytes of 0 or 1 to eight bits, byte i to bit i, by one multiplication (Hacker's Delight, 7-2).
constexpr uint64_t gatherBits(uint64_t ones) {
    return ones * 0x0102040810204080ull >> 56;
}
/// spreadBits() of each byte.
inline constexpr std::array<uint64_t, 256> kSpreadBits = [] {
    std::array<uint64_t, 256> out{};
    for (uint64_t bits = 0; bits < 256; ++bits) out[bits] = nonZeroBytes(bits * kByteOnes & 0x8040201008040201ull);
    return out;
}();
/// The inverse of gatherBits(): the lowest eight bits to eight bytes of 0 or 1.
constexpr uint64_t spreadBits(uint64_t bits) {
    return kSpreadBits[bits & 0xff];
}

/// Eight bytes from any address, the first one lowest.
inline uint64_t loadBytes(const uint8_t* bytes) {
    uint64_t out;
    std::memcpy(&out, bytes, 8);
    return out;
}

/// One bit for each of 64 bytes: whether it equals `value`.
inline uint64_t equalBits(const uint8_t* bytes, uint8_t value) {
    uint64_t out = 0;
#if defined(__SSE2__)
    const __m128i wanted = _mm_set1_epi8(char(value));
    for (int i = 0; i < 64; i += 16) {
        const __m128i found = _mm_cmpeq_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes + i)), wanted);
        out |= uint64_t(uint32_t(_mm_movemask_epi8(found))) << i;
    }
#else
    for (int i = 0; i < 64; i += 8)
        out |= (gatherBits(nonZeroBytes(loadBytes(bytes + i) ^ value * kByteOnes)) ^ 0xff) << i;
#endif
    return out;
}

}  // namespace rubble
