#include "runtime/voxel/palette.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/hash.h"

namespace rubble {

uint64_t hashPalette(const Palette& palette) {
    static_assert(sizeof(PaletteEntry) == 16, "hashed as bytes: no padding");
    return hashBytes(palette.data(), sizeof palette);
}

float srgbToLinear(uint8_t value) {
    static const auto table = [] {
        std::array<float, 256> t{};
        for (int i = 0; i < 256; ++i) {
            const double v = i / 255.0;
            t[size_t(i)] = float(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
        }
        return t;
    }();
    return table[value];
}

uint8_t linearToSrgb(float value) {
    const double v = std::clamp(double(value), 0.0, 1.0);
    return uint8_t((v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055) * 255.0 + 0.5);
}

}  // namespace rubble
