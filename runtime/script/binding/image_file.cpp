#include "runtime/script/binding/image_file.h"

#include <png.h>

namespace rubble::script {

std::string readPng(const std::string& path, size_t maxBytes, UiImage& out) {
    constexpr uint32_t kMaxSide = 4096;
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, path.c_str())) return image.message;
    std::string error;
    image.format = PNG_FORMAT_RGBA;
    if (image.width > kMaxSide || image.height > kMaxSide) {
        error = "expected at most 4096 x 4096 pixels, found " + std::to_string(image.width) + " x " +
                std::to_string(image.height);
    } else if (PNG_IMAGE_SIZE(image) > maxBytes) {
        error = "expected at most " + std::to_string(maxBytes >> 20) + " MiB more of images, found " +
                std::to_string(PNG_IMAGE_SIZE(image) >> 20);
    } else {
        out.width = image.width, out.height = image.height;
        out.pixels.resize(PNG_IMAGE_SIZE(image));
        if (!png_image_finish_read(&image, nullptr, out.pixels.data(), 0, nullptr)) error = image.message;
    }
    png_image_free(&image);
    return error;
}

}  // namespace rubble::script
