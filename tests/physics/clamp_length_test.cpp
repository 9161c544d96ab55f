#include "physics/math/clamp_length.h"

#include <gtest/gtest.h>

#include <random>

namespace rubble {
namespace {

TEST(ClampLength, NoResultIsLongerThanTheLimitByTheLastBit) {
    std::mt19937_64 random(7);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-52 - 1.0; };
    for (int i = 0; i < 100'000; ++i) {
        const double limit = i % 2 ? 1e3 : 60.0;
        glm::dvec3 v{unit(), unit(), unit()};
        v *= 4.0 * limit;
        const glm::dvec3 clamped = clampedLength(v, limit);
        ASSERT_LE(glm::length(clamped), limit) << v.x << " " << v.y << " " << v.z;
        ASSERT_GE(glm::length(clamped), std::min(limit, glm::length(v)) * (1.0 - 1e-14));
        ASSERT_EQ(clampedLength(clamped, limit), clamped);
    }
}

}  // namespace
}  // namespace rubble
