#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace editor {

/// An image, rows from above, sRGB with opacity.
struct Image {
    glm::ivec2 size{0};
    std::vector<std::array<uint8_t, 4>> pixels;
    /// The pixel of a column and a row.
    const std::array<uint8_t, 4>& at(int x, int y) const { return pixels[size_t(y) * size_t(size.x) + size_t(x)]; }
};

/// Reads a PNG file of at most 4096 x 4096 pixels. Throws Refused.
Image readImage(const std::string& path);

/// What an image says of heights.
struct Heights {
    glm::ivec2 size{0};
    std::vector<double> values;  ///< brightness from 0 to 1, rows from above; negative: not opaque
};
/// Reads them from a PNG file of at most 4096 x 4096 pixels, of 8 or 16 bits a value. Throws Refused.
Heights readHeights(const std::string& path);

using Rgb = std::array<uint8_t, 3>;
/// At most `count` colours that stand for those of the opaque pixels, by median cut: the colours themselves where they
/// are no more.
std::vector<Rgb> reduceColors(const Image& image, size_t count);
/// Which of some colours is nearest to one.
size_t nearestColor(const std::vector<Rgb>& colors, const std::array<uint8_t, 4>& pixel);
/// Whether a pixel counts as opaque.
inline bool isOpaque(const std::array<uint8_t, 4>& pixel) {
    return pixel[3] >= 128;
}

}  // namespace editor
