#pragma once
#include <cmath>
#include <cstdint>

namespace sandbox::sound {

/// Random numbers that are the same in each run: xorshift32.
class Random {
public:
    /// Of a seed, which may be 0.
    explicit Random(uint32_t seed) : m_state(seed * 2654435761u | 1u) {}
    /// 32 of them.
    uint32_t bits() {
        m_state ^= m_state << 13;
        m_state ^= m_state >> 17;
        m_state ^= m_state << 5;
        return m_state;
    }
    /// In [0, 1).
    float unit() { return float(bits() >> 8) * 0x1p-24f; }
    /// In [-1, 1).
    float sign() { return 2.0f * unit() - 1.0f; }
    /// Exponentially distributed, of mean 1.
    float exponential() { return -std::log(1.0f - unit()); }

private:
    uint32_t m_state;
};

}  // namespace sandbox::sound
