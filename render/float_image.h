#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace rubble {

/// An image of linear values of any range: rgba, rows from the bottom.
struct FloatImage {
    glm::ivec2 size{0};
    std::vector<glm::vec4> pixels;

    FloatImage() = default;
    /// All zero. given: columns and rows.
    explicit FloatImage(glm::ivec2 given) : size(given), pixels(size_t(given.x) * size_t(given.y), glm::vec4(0.0f)) {}
    /// Opaque, of bytes: red, green and blue of each pixel.
    FloatImage(glm::ivec2 given, std::span<const uint8_t> rgb) : FloatImage(given) {
        for (size_t i = 0; i < pixels.size(); ++i)
            pixels[i] = glm::vec4(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2], 255.0f) / 255.0f;
    }
    /// The pixel at column x of row y.
    glm::vec4& at(int x, int y) { return pixels[size_t(y) * size_t(size.x) + size_t(x)]; }
    /// The same of a constant image.
    const glm::vec4& at(int x, int y) const { return pixels[size_t(y) * size_t(size.x) + size_t(x)]; }
};

}  // namespace rubble
