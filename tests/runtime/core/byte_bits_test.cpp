#include "runtime/core/byte_bits.h"

#include <gtest/gtest.h>

#include <array>

#include "runtime/core/random.h"

namespace rubble {
namespace {

TEST(ByteBits, FindEqualAndNonZeroBytes) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        std::array<uint8_t, 64> bytes;
        for (uint8_t& byte : bytes) byte = std::array<uint8_t, 5>{0, 1, 0x7f, 0x80, 0xff}[random.below(5)];
        for (const uint8_t value : {0, 1, 0x7f, 0x80, 0xff, 3}) {
            const uint64_t bits = equalBits(bytes.data(), value);
            for (size_t b = 0; b < 64; ++b) ASSERT_EQ(bits >> b & 1, uint64_t(bytes[b] == value));
        }
        const uint64_t solid = gatherBits(nonZeroBytes(loadBytes(bytes.data())));
        for (size_t b = 0; b < 8; ++b) ASSERT_EQ(solid >> b & 1, uint64_t(bytes[b] != 0));
        ASSERT_EQ(gatherBits(spreadBits(solid)), solid);
    }
}

}  // namespace
}  // namespace rubble
