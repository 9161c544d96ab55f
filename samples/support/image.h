#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// 8-bit RGB, rows from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;

    Image() = default;
    Image(int w, int h) : width(w), height(h), rgb(size_t(w) * h * 3) {}
    uint8_t* at(int x, int y) { return &rgb[(size_t(y) * width + x) * 3]; }
    const uint8_t* at(int x, int y) const { return &rgb[(size_t(y) * width + x) * 3]; }
};

Result<Done> writePng(const std::string& path, const Image& image);
Result<Image> readPng(const std::string& path);
/// The image at 1/factor of its size, by averaging.
Image shrink(const Image& image, int factor);
/// Images of one size in rows of `columns`, with a gap between them.
Image tile(const std::vector<Image>& images, int columns, int gap = 4);

}  // namespace rubble
