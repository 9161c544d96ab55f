#include "tests/golden/compare.h"

#include <algorithm>
#include <cstdlib>

namespace rubble {
namespace {

constexpr int kClearlyDifferent = 24;      // of 255
constexpr double kDifferentShare = 0.005;  // of the pixels
constexpr double kMeanDifference = 1.0;    // of 255

}  // namespace

Difference compare(const Image& actual, const Image& expected) {
    Difference difference{Image(actual.width, actual.height)};
    const size_t pixels = actual.rgb.size() / 3;
    for (size_t i = 0; i < pixels; ++i) {
        int largest = 0;
        for (size_t k = i * 3; k < i * 3 + 3; ++k) {
            const int d = std::abs(int(actual.rgb[k]) - int(expected.rgb[k]));
            difference.image.rgb[k] = uint8_t(std::min(255, 4 * d));
            difference.mean += d / double(actual.rgb.size());
            largest = std::max(largest, d);
        }
        difference.share += (largest > kClearlyDifferent) / double(pixels);
    }
    return difference;
}

bool looksAlike(const Difference& difference) {
    return difference.share <= kDifferentShare && difference.mean <= kMeanDifference;
}

}  // namespace rubble
