#pragma once
#include <cstdint>

namespace rubble {

/// PCG32 (M. O'Neill 2014, pcg-random.org): a small seeded generator. The same seed gives the same sequence on every
/// machine. Draw into named variables: C++ does not fix the order of two draws in one expression.
class Random {
public:
    /// Generators of the same seed and other streams give independent sequences.
    explicit Random(uint64_t seed, uint64_t stream = 0) : m_increment(stream << 1 | 1) {
        next();
        m_state += seed;
        next();
    }
    /// 32 uniformly distributed bits.
    uint32_t next() {
        const uint64_t old = m_state;
        m_state = old * 6364136223846793005ull + m_increment;
        const uint32_t shifted = uint32_t(((old >> 18) ^ old) >> 27);
        const uint32_t rotation = uint32_t(old >> 59);
        return shifted >> rotation | shifted << (-rotation & 31);
    }
    /// Uniform in [0, bound), by multiplication (Lemire 2019); bound > 0. The bias is below bound / 2^32.
    uint32_t below(uint32_t bound) { return uint32_t(uint64_t(next()) * bound >> 32); }
    /// Uniform in [low, high], both included.
    int between(int low, int high) { return low + int(below(uint32_t(high - low + 1))); }
    /// Uniform in [0, 1), a multiple of 2^-24, which a float holds exactly.
    float unit() { return float(next() >> 8) * 0x1p-24f; }

private:
    uint64_t m_state = 0;
    uint64_t m_increment;
};

/// A well-mixed hash of a cell: randomness that does not depend on the order in which cells are visited.
constexpr uint32_t hashCell(int x, int y, int z, uint32_t seed = 0) {
    uint32_t h = seed * 0x9e3779b9u + uint32_t(x) * 0x85ebca6bu;
    h = (h ^ h >> 15) * 0xc2b2ae35u + uint32_t(y) * 0x27d4eb2fu;
    h = (h ^ h >> 13) * 0x165667b1u + uint32_t(z) * 0x9e3779b1u;
    h = (h ^ h >> 16) * 0x85ebca6bu;
    return h ^ h >> 15;
}

}  // namespace rubble
