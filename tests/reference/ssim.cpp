#include "tests/reference/ssim.h"

#include <array>
#include <cassert>
#include <cmath>

namespace rubble::reference {
namespace {

constexpr int kRadius = 5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

std::array<double, 2 * kRadius + 1> window() {
    std::array<double, 2 * kRadius + 1> weights{};
    double sum = 0.0;
    for (int i = -kRadius; i <= kRadius; ++i)
        sum += weights[size_t(i + kRadius)] = std::exp(-i * i / (2.0 * 1.5 * 1.5));
    for (double& w : weights) w /= sum;
    return weights;
}

double luma(const glm::vec4& p) {
    return 0.299 * p.r + 0.587 * p.g + 0.114 * p.b;
}

}  // namespace

double ssim(const FloatImage& reference, const FloatImage& test) {
    assert(reference.size == test.size);
    const auto weights = window();
    double total = 0.0;
    int windows = 0;
    for (int y = kRadius; y < reference.size.y - kRadius; ++y)
        for (int x = kRadius; x < reference.size.x - kRadius; ++x) {
            double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
            for (int dy = -kRadius; dy <= kRadius; ++dy)
                for (int dx = -kRadius; dx <= kRadius; ++dx) {
                    const double w = weights[size_t(dx + kRadius)] * weights[size_t(dy + kRadius)];
                    const double p = luma(reference.at(x + dx, y + dy)), q = luma(test.at(x + dx, y + dy));
                    a += w * p, b += w * q, aa += w * p * p, bb += w * q * q, ab += w * p * q;
                }
            const double varianceA = aa - a * a, varianceB = bb - b * b, both = ab - a * b;
            total += (2 * a * b + kC1) * (2 * both + kC2) / ((a * a + b * b + kC1) * (varianceA + varianceB + kC2));
            ++windows;
        }
    return windows ? total / windows : 1.0;
}

}  // namespace rubble::reference
