#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/float_image.h"

namespace rubble::reference {

/// Mean radiance of the drawn image over that of the reference, over the pixels that are on an object with all their
/// neighbours: edge pixels depend on the last frame's jitter. isOn(index of a pixel) tells which are. NaN if none is.
template <class F>
glm::dvec3 brightnessRatio(const FloatImage& drawn, const FloatImage& reference, F&& isOn) {
    glm::dvec3 sum(0.0), sumReference(0.0);
    for (int y = 1; y + 1 < drawn.size.y; ++y)
        for (int x = 1; x + 1 < drawn.size.x; ++x) {
            bool inside = true;
            for (int i = 0; i < 9; ++i) inside = inside && isOn(size_t(x + i % 3 - 1 + (y + i / 3 - 1) * drawn.size.x));
            if (!inside) continue;
            const auto p = size_t(x + y * drawn.size.x);
            sum += glm::dvec3(drawn.pixels[p]), sumReference += glm::dvec3(reference.pixels[p]);
        }
    return sum / sumReference;  // NaN fails every test
}

}  // namespace rubble::reference
