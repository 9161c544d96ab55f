#include "tests/reference/display.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace rubble::reference {
namespace {

float filmCurve(float x) {
    return std::clamp((x * (2.51f * x + 0.05f)) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
}

float toSrgb(float c) {
    return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
}

}  // namespace

FloatImage displayed(const FloatImage& radiance, float exposure) {
    FloatImage out = radiance;
    for (glm::vec4& p : out.pixels)
        for (int c = 0; c < 3; ++c) p[c] = toSrgb(filmCurve(std::max(p[c], 0.0f) * exposure * 0.5f));
    return out;
}

float exposureFor(const FloatImage& radiance, float ofLevel) {
    double sum = 0.0, total = 0.0;
    for (int y = 0; y < radiance.size.y; ++y)
        for (int x = 0; x < radiance.size.x; ++x) {
            const glm::dvec2 aside = (glm::dvec2(x, y) + 0.5) / glm::dvec2(radiance.size) - 0.5;
            const double w = std::exp(-3.0 * glm::dot(aside, aside));
            const glm::vec4& p = radiance.at(x, y);
            const double luminance = 0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b;
            sum += w * std::log2(std::clamp(luminance * ofLevel, 0.01, 8.0));
            total += w;
        }
    return ofLevel * float(std::clamp(std::pow(0.34 / std::exp2(sum / total), 0.45), 0.7, 2.2));
}

Image toImage(const FloatImage& srgb) {
    Image image(srgb.size.x, srgb.size.y);
    for (int y = 0; y < srgb.size.y; ++y)
        for (int x = 0; x < srgb.size.x; ++x)
            for (int c = 0; c < 3; ++c)
                image.at(x, srgb.size.y - 1 - y)[c] =
                    uint8_t(std::lround(255.0f * glm::clamp(srgb.at(x, y)[c], 0.0f, 1.0f)));
    return image;
}

}  // namespace rubble::reference
