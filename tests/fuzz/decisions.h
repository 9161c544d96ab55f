#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "runtime/core/hash.h"
#include "runtime/core/number_range.h"
#include "runtime/core/random.h"

namespace rubble {

/// The choices of a fuzzer. They come from its input, four bytes each, so that libFuzzer can steer them; when the input
/// is used up, from a generator that it seeds. The same input gives the same choices.
class Decisions {
public:
    /// `data` must outlive it.
    Decisions(const uint8_t* data, size_t size) : m_input(data, size), m_random(hashBytes(data, size)) {}

    /// Uniform in [0, bound); 0 for a bound of 0.
    uint32_t below(uint32_t bound) { return bound ? uint32_t(uint64_t(next()) * bound >> 32) : 0; }
    /// True in one of so many cases.
    bool oneIn(uint32_t cases) { return below(cases) == 0; }
    /// Uniform in [0, 1).
    double unit() { return double(next()) * 0x1p-32; }
    /// 64 random bits.
    uint64_t bits() {
        const uint64_t high = next();
        return high << 32 | next();
    }
    /// In a range, often one of its ends.
    double within(NumberRange range) {
        const uint32_t choice = below(8);
        if (choice == 0) return range.low;
        if (choice == 1) return range.high;
        return range.low + (range.high - range.low) * unit();
    }
    /// A number as nobody should give it, and sometimes a usual one.
    double wild() {
        static constexpr double kNumbers[] = {0.0,  -0.0, 1.0,   -1.0,   0.5,  1e-300, 1e-9,     1e-3,
                                              0.1,  10.0, 100.0, 1000.0, 1e4,  1e6,    1e9,      1e12,
                                              1e16, 1e30, 1e300, -100.0, -1e9, -1e30,  16777216, 2147483648.0};
        const uint32_t choice = below(32);
        if (choice < std::size(kNumbers)) return kNumbers[choice];
        if (choice == 24) return std::numeric_limits<double>::quiet_NaN();
        if (choice == 25) return std::numeric_limits<double>::infinity();
        if (choice == 26) return -std::numeric_limits<double>::infinity();
        return (unit() - 0.5) * 20.0;
    }
    /// A place near the origin, where small levels are; rarely a wild one.
    glm::dvec3 place() {
        glm::dvec3 out;
        for (int i = 0; i < 3; ++i) out[i] = oneIn(100) ? wild() : unit() * 1.8 - 0.3;
        return out;
    }

private:
    uint32_t next() {
        if (m_input.size() < 4) return m_random.next();
        const uint32_t value =
            uint32_t(m_input[0]) | uint32_t(m_input[1]) << 8 | uint32_t(m_input[2]) << 16 | uint32_t(m_input[3]) << 24;
        m_input = m_input.subspan(4);
        return value;
    }
    std::span<const uint8_t> m_input;
    Random m_random;
};

/// One input of a fuzzer; each NAME_fuzzer.cpp defines it, or an entry of its own instead. Aborts on a fault.
void fuzz(Decisions& decisions);

}  // namespace rubble
