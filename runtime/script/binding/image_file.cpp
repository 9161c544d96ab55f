#include "runtime/script/binding/image_file.h"

#include <vector>

#include "runtime/assets/png_pixels.h"

namespace rubble::script {

std::string readPng(const std::string& path, size_t maxBytes, UiImage& out) {
    constexpr uint32_t kMaxSide = 4096;
    std::vector<uint8_t> bytes;
    if (std::string wrong = readImageBytes(path, bytes); !wrong.empty()) return wrong;
    std::string refusal;
    const std::string error = readPngPixels(bytes, [&](uint32_t width, uint32_t height) -> void* {
        const size_t size = size_t(4) * width * height;
        if (width > kMaxSide || height > kMaxSide)
            refusal =
                "expected at most 4096 x 4096 pixels, found " + std::to_string(width) + " x " + std::to_string(height);
        else if (size > maxBytes)
            refusal = "expected at most " + std::to_string(maxBytes >> 20) + " MiB more of images, found " +
                      std::to_string(size >> 20);
        if (!refusal.empty()) return nullptr;
        out.width = width, out.height = height;
        out.pixels.resize(size);
        return out.pixels.data();
    });
    return refusal.empty() ? error : refusal;
}

}  // namespace rubble::script
