#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/float_image.h"

namespace rubble::reference {

/// Mean radiance drawn over mean radiance true, of the pixels that lie on something with all their neighbours: which
/// pixels of its edges do is up to the last picture's jitter. isOn(pixel's index).
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
    return sum / sumReference;  // no number if nothing is inside: no test passes then
}

}  // namespace rubble::reference
