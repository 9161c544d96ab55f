#pragma once
#include <cstdint>

namespace rubble {

/// PCG32 (O'Neill 2014, pcg-random.org): a small seeded generator whose sequence is the same everywhere.
/// Draw into named variables: two draws in one expression have no fixed order.
class Random {
public:
    explicit Random(uint64_t seed, uint64_t stream = 0) : m_increment(stream << 1 | 1) {
        next();
        m_state += seed;
        next();
    }
    uint32_t next() {
        const uint64_t old = m_state;
        m_state = old * 6364136223846793005ull + m_increment;
        const uint32_t shifted = uint32_t(((old >> 18) ^ old) >> 27);
        const uint32_t rotation = uint32_t(old >> 59);
        return shifted >> rotation | shifted << (-rotation & 31);
    }
    /// In [0, bound); bound > 0. Bias below bound / 2^32.
    uint32_t below(uint32_t bound) { return uint32_t(uint64_t(next()) * bound >> 32); }
    /// In [low, high].
    int between(int low, int high) { return low + int(below(uint32_t(high - low + 1))); }
    /// In [0, 1), a multiple of 2^-24: exact in float.
    float unit() { return float(next() >> 8) * 0x1p-24f; }

private:
    uint64_t m_state = 0;
    uint64_t m_increment;
};

/// A well-mixed hash of a cell, for patterns that must not depend on the order they are made in.
constexpr uint32_t hashCell(int x, int y, int z, uint32_t seed = 0) {
    uint32_t h = seed * 0x9e3779b9u + uint32_t(x) * 0x85ebca6bu;
    h = (h ^ h >> 15) * 0xc2b2ae35u + uint32_t(y) * 0x27d4eb2fu;
    h = (h ^ h >> 13) * 0x165667b1u + uint32_t(z) * 0x9e3779b1u;
    h = (h ^ h >> 16) * 0x85ebca6bu;
    return h ^ h >> 15;
}

}  // namespace rubble
