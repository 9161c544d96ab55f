#include "editor/core/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "editor/core/arguments.h"
#include "runtime/assets/png_pixels.h"

namespace editor {
namespace {

constexpr uint32_t kMaxSide = 4096;

/// A colour of the image and how many pixels have it.
struct Counted {
    Rgb color;
    uint64_t pixels;
};

/// A part of the colours, and its largest extent.
struct Part {
    size_t begin, end;
    int extent = 0, axis = 0;
};

Part partOf(const std::vector<Counted>& all, size_t begin, size_t end) {
    Part part{begin, end};
    for (int axis = 0; axis < 3; ++axis) {
        const auto less = [axis](const Counted& a, const Counted& b) {
            return a.color[size_t(axis)] < b.color[size_t(axis)];
        };
        const auto [low, high] =
            std::minmax_element(all.begin() + ptrdiff_t(begin), all.begin() + ptrdiff_t(end), less);
        const int extent = high->color[size_t(axis)] - low->color[size_t(axis)];
        if (extent > part.extent) part.extent = extent, part.axis = axis;
    }
    return part;
}

/// Where half of a part's pixels are on either side; each side has a colour at least.
size_t middleOf(const std::vector<Counted>& all, const Part& part) {
    uint64_t pixels = 0, half = 0;
    for (size_t i = part.begin; i < part.end; ++i) pixels += all[i].pixels;
    size_t at = part.begin;
    while (at < part.end - 1 && half + all[at].pixels <= pixels / 2) half += all[at++].pixels;
    return std::clamp(at, part.begin + 1, part.end - 1);
}

Rgb meanOf(const std::vector<Counted>& all, const Part& part) {
    uint64_t sum[3] = {}, pixels = 0;
    for (size_t i = part.begin; i < part.end; ++i) {
        for (size_t a = 0; a < 3; ++a) sum[a] += all[i].color[a] * all[i].pixels;
        pixels += all[i].pixels;
    }
    Rgb mean;
    for (size_t a = 0; a < 3; ++a) mean[a] = uint8_t((sum[a] + pixels / 2) / pixels);
    return mean;
}

/// Reads a file by read(bytes, measure); measure(width, height) checks the size and gives the number of pixels.
template <class Read>
void readWith(const std::string& path, glm::ivec2& size, Read&& read) {
    std::vector<uint8_t> bytes;
    if (const std::string wrong = rubble::readImageBytes(path, bytes); !wrong.empty())
        throw Refused(fmt::format("{}: {}", path, wrong));
    const std::string error = read(bytes, [&](uint32_t width, uint32_t height) {
        if (width > kMaxSide || height > kMaxSide)
            throw Refused(fmt::format("{}: expected at most {} x {} pixels, found {} x {}", path, kMaxSide, kMaxSide,
                                      width, height));
        size = {int(width), int(height)};
        return size_t(width) * height;
    });
    if (!error.empty())
        throw Refused(fmt::format("{}: expected a PNG file, found one that cannot be read: {}", path, error));
}

}  // namespace

Image readImage(const std::string& path) {
    Image image;
    readWith(path, image.size, [&](const std::vector<uint8_t>& bytes, const auto& measure) {
        return rubble::readPngPixels(bytes, [&](uint32_t width, uint32_t height) {
            image.pixels.resize(measure(width, height));
            return image.pixels.data();
        });
    });
    return image;
}

Heights readHeights(const std::string& path) {
    Heights heights;
    std::vector<std::array<uint16_t, 4>> pixels;
    readWith(path, heights.size, [&](const std::vector<uint8_t>& bytes, const auto& measure) {
        return rubble::readDeepPngPixels(bytes, [&](uint32_t width, uint32_t height) {
            pixels.resize(measure(width, height));
            return pixels.data()->data();
        });
    });
    for (const auto& [red, green, blue, opacity] : pixels)
        heights.values.push_back(opacity < 32768 ? -1.0 : (0.2126 * red + 0.7152 * green + 0.0722 * blue) / 65535.0);
    return heights;
}

std::vector<Rgb> reduceColors(const Image& image, size_t count) {
    std::map<Rgb, uint64_t> counts;
    for (const auto& pixel : image.pixels)
        if (isOpaque(pixel)) ++counts[{pixel[0], pixel[1], pixel[2]}];
    if (counts.empty()) return {};
    std::vector<Counted> all;
    for (const auto& [color, pixels] : counts) all.push_back({color, pixels});
    std::vector<Part> parts{partOf(all, 0, all.size())};
    while (parts.size() < count) {
        const auto widest = std::max_element(parts.begin(), parts.end(),
                                             [](const Part& a, const Part& b) { return a.extent < b.extent; });
        if (widest->extent == 0) break;
        const auto axis = size_t(widest->axis);
        std::sort(all.begin() + ptrdiff_t(widest->begin), all.begin() + ptrdiff_t(widest->end),
                  [axis](const Counted& a, const Counted& b) {
                      return a.color[axis] != b.color[axis] ? a.color[axis] < b.color[axis] : a.color < b.color;
                  });
        const size_t middle = middleOf(all, *widest), end = widest->end;
        *widest = partOf(all, widest->begin, middle);
        parts.push_back(partOf(all, middle, end));
    }
    std::vector<Rgb> out;
    for (const Part& part : parts) out.push_back(meanOf(all, part));
    std::sort(out.begin(), out.end());
    return out;
}

size_t nearestColor(const std::vector<Rgb>& colors, const std::array<uint8_t, 4>& pixel) {
    const auto distance = [&](const Rgb& color) {
        int sum = 0;
        for (size_t a = 0; a < 3; ++a) sum += (color[a] - pixel[a]) * (color[a] - pixel[a]);
        return sum;
    };
    return size_t(std::min_element(colors.begin(), colors.end(),
                                   [&](const Rgb& a, const Rgb& b) { return distance(a) < distance(b); }) -
                  colors.begin());
}

}  // namespace editor
