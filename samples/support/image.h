#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// 8-bit RGB image, rows from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;

    Image() = default;
    /// A black image.
    Image(int w, int h) : width(w), height(h), rgb(size_t(w) * h * 3) {}
    /// The three channels of a pixel.
    uint8_t* at(int x, int y) { return &rgb[(size_t(y) * width + x) * 3]; }
    /// The three channels of a pixel.
    const uint8_t* at(int x, int y) const { return &rgb[(size_t(y) * width + x) * 3]; }
};

/// Writes an image as PNG. An error names the file.
Result<Done> writePng(const std::string& path, const Image& image);
/// Reads a PNG of any format as 8-bit RGB. An error names the file.
Result<Image> readPng(const std::string& path);
/// Images of one size side by side in rows of `columns`. gap: pixels between them.
Image tile(const std::vector<Image>& images, int columns, int gap = 4);

}  // namespace rubble
