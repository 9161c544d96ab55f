#include <gtest/gtest.h>

#include <cmath>

#include "runtime/core/random.h"
#include "tests/reference/relative_error.h"
#include "tests/reference/ssim.h"

namespace rubble::reference {
namespace {

FloatImage plain(float value) {
    FloatImage image({32, 24});
    for (glm::vec4& p : image.pixels) p = glm::vec4(value);
    return image;
}

FloatImage noisy(const FloatImage& from, float strength, uint64_t seed) {
    FloatImage image = from;
    Random random(seed);
    for (glm::vec4& p : image.pixels) p += glm::vec4((random.unit() - 0.5f) * strength);
    return image;
}

TEST(RelativeError, IsTheSquareOfTheShare) {
    EXPECT_EQ(relativeError(plain(1.0f), plain(1.0f)), 0.0);
    EXPECT_NEAR(relativeError(plain(1.0f), plain(1.1f)), 0.01 / 1.01, 1e-6);
    EXPECT_NEAR(relativeError(plain(10.0f), plain(11.0f)), 1.0 / 100.01, 1e-6)
        << "the same share of ten times the light";
}

TEST(RelativeError, AFewSpecksAreLeftOut) {
    FloatImage image({100, 100});
    for (glm::vec4& p : image.pixels) p = glm::vec4(1.0f);
    FloatImage specks = image;
    for (int i = 0; i < 10; ++i) specks.at(i, 0) = glm::vec4(100.0f);
    EXPECT_EQ(relativeError(image, specks), 0.0);
    specks.at(50, 50) = glm::vec4(2.0f);
    EXPECT_GT(relativeError(image, specks), 0.0);
}

/// Two uniform images differ only in their means: (2ab + C1) / (a^2 + b^2 + C1), C1 = 0.0001 (equation 6 of the paper).
TEST(Ssim, UniformImagesHaveAClosedForm) {
    EXPECT_NEAR(ssim(plain(0.5f), plain(0.5f)), 1.0, 1e-12);
    EXPECT_NEAR(ssim(plain(0.5f), plain(0.25f)), (2 * 0.125 + 1e-4) / (0.3125 + 1e-4), 1e-6);
}

TEST(Ssim, OppositeStructureIsNegativeAndNoiseLowersIt) {
    const FloatImage gray = plain(0.5f), texture = noisy(gray, 0.5f, 1);
    FloatImage opposite = texture;
    for (glm::vec4& p : opposite.pixels) p = glm::vec4(1.0f) - p;
    EXPECT_LT(ssim(texture, opposite), -0.8);
    EXPECT_GT(ssim(texture, noisy(texture, 0.02f, 2)), ssim(texture, noisy(texture, 0.1f, 3)));
}

}  // namespace
}  // namespace rubble::reference
