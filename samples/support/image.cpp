#include "samples/support/image.h"

#include <png.h>

#include <algorithm>

namespace rubble {

Result<Done> writePng(const std::string& path, const Image& image) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(image.width);
    png.height = png_uint_32(image.height);
    png.format = PNG_FORMAT_RGB;
    png.flags = PNG_IMAGE_FLAG_FAST;
    if (!png_image_write_to_file(&png, path.c_str(), 0, image.rgb.data(), 0, nullptr))
        return Error{path + ": cannot write PNG: " + png.message};
    return Done{};
}

Result<Image> readPng(const std::string& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, path.c_str())) return Error{path + ": cannot read PNG: " + png.message};
    png.format = PNG_FORMAT_RGB;
    Image image(int(png.width), int(png.height));
    if (!png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr))
        return Error{path + ": cannot read PNG: " + png.message};
    return image;
}

Image shrink(const Image& image, int factor) {
    Image out(image.width / factor, image.height / factor);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int dy = 0; dy < factor; ++dy)
                    for (int dx = 0; dx < factor; ++dx) sum += image.at(x * factor + dx, y * factor + dy)[channel];
                out.at(x, y)[channel] = uint8_t((sum + factor * factor / 2) / (factor * factor));
            }
    return out;
}

Image tile(const std::vector<Image>& images, int columns, int gap) {
    if (images.empty()) return {};
    const int width = images[0].width, height = images[0].height;
    const int rows = (int(images.size()) + columns - 1) / columns;
    Image out(columns * width + (columns + 1) * gap, rows * height + (rows + 1) * gap);
    std::fill(out.rgb.begin(), out.rgb.end(), uint8_t(24));
    for (size_t i = 0; i < images.size(); ++i) {
        const int left = gap + int(i) % columns * (width + gap), top = gap + int(i) / columns * (height + gap);
        for (int y = 0; y < std::min(height, images[i].height); ++y)
            std::copy_n(images[i].at(0, y), size_t(std::min(width, images[i].width)) * 3, out.at(left, top + y));
    }
    return out;
}

}  // namespace rubble
