#pragma once
// For the libraries that link libpng; only their .cpp files include it.
#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace rubble {

/// Reads the bytes of an image's file: a regular one of at most 256 MiB. Returns what is wrong with it, or "".
inline std::string readImageBytes(const std::string& path, std::vector<uint8_t>& out) {
    constexpr uintmax_t kMaxBytes = uintmax_t(256) << 20;
    std::error_code wrong;
    const bool isRegular = std::filesystem::is_regular_file(path, wrong);
    if (wrong) return wrong.message();
    if (!isRegular) return "expected a regular file, found another kind";
    const uintmax_t size = std::filesystem::file_size(path, wrong);
    if (wrong) return wrong.message();
    if (size > kMaxBytes) return "expected at most 256 MiB, found " + std::to_string(size >> 20);
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::strerror(errno);
    out.resize(size_t(size));
    file.read(reinterpret_cast<char*>(out.data()), std::streamsize(size));
    out.resize(size_t(file.gcount()));
    return "";
}

/// A PNG file without the chunks that say how its values were bent: libpng would bend them back.
inline std::vector<uint8_t> withoutGamma(std::span<const uint8_t> png) {
    static constexpr std::string_view kLeftOut[] = {"gAMA", "cHRM", "sRGB", "iCCP"};
    constexpr size_t kSignature = 8, kAround = 12;  // bytes: of a chunk its length, name and checksum
    std::vector<uint8_t> out(png.begin(), png.begin() + ptrdiff_t(std::min(png.size(), kSignature)));
    for (size_t at = kSignature; at < png.size();) {
        size_t size = png.size() - at;
        std::string_view name;
        if (size >= kAround) {
            const auto byte = [&](size_t i) { return size_t(png[at + i]); };
            size = std::min(size, (byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3)) + kAround);
            name = {reinterpret_cast<const char*>(png.data() + at + 4), 4};
        }
        if (std::ranges::find(kLeftOut, name) == std::end(kLeftOut))
            out.insert(out.end(), png.begin() + ptrdiff_t(at), png.begin() + ptrdiff_t(at + size));
        at += size;
    }
    return out;
}

/// Reads a PNG file as the values that it stores: rows from above, red, green, blue and opacity, a byte each. 16 bits
/// are rounded to 8, and nothing is made of its gamma. place(width, height) gives memory for the pixels, or null where
/// they are not wanted. Returns what is wrong with the file; empty: nothing.
template <class Place>
std::string readPngPixels(std::span<const uint8_t> bytes, Place place) {
    const std::vector<uint8_t> plain = withoutGamma(bytes);
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&png, plain.data(), plain.size())) return png.message;
    struct Release {
        png_image& png;
        ~Release() { png_image_free(&png); }
    } const release{png};
    png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // else it takes 16 bits for linear light
    png.format = PNG_FORMAT_RGBA;
    void* const pixels = place(png.width, png.height);
    return !pixels || png_image_finish_read(&png, nullptr, pixels, 0, nullptr) ? "" : png.message;
}

/// The same with 16 bits a value; those of 8 bits are spread.
template <class Place>
std::string readDeepPngPixels(std::span<const uint8_t> bytes, Place place) {
    const std::vector<uint8_t> plain = withoutGamma(bytes);
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&png, plain.data(), plain.size())) return png.message;
    const bool isDeep = png.format & PNG_FORMAT_FLAG_LINEAR;
    uint16_t* const pixels = place(png.width, png.height);
    const size_t count = size_t(png.width) * png.height * 4;
    if (!isDeep || !pixels) {
        png_image_free(&png);
        std::vector<uint8_t> shallow(pixels ? count : 0);
        const std::string error =
            readPngPixels(bytes, [&](uint32_t, uint32_t) { return pixels ? shallow.data() : nullptr; });
        std::ranges::transform(shallow, pixels, [](uint8_t value) { return uint16_t(value * 257); });
        return error;
    }
    png.format = PNG_FORMAT_LINEAR_RGB_ALPHA;  // the values as they are, but times the opacity
    if (!png_image_finish_read(&png, nullptr, pixels, 0, nullptr)) return png.message;
    for (size_t i = 0; i < count; i += 4)
        for (size_t c = 0; c < 3; ++c)
            if (const uint32_t opacity = pixels[i + 3]; opacity && opacity < 65535)
                pixels[i + c] =
                    uint16_t(std::min<uint64_t>(65535, (uint64_t(pixels[i + c]) * 65535 + opacity / 2) / opacity));
    return "";
}

}  // namespace rubble
