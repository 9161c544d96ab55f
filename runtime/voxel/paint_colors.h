#pragma once
#include <array>
#include <cstdint>
#include <memory>

namespace rubble {

// The paint layer: a byte for each voxel beside its palette index. 0 is unpainted; else the high four bits are a colour
// of the shape (1 to 15), and the low four bits, plus one, are the weight of that colour over the voxel's own, in
// sixteenths.
inline constexpr int kPaintColors = 15;  ///< colours of a shape
inline constexpr int kPaintSteps = 16;   ///< blend weights: 1/16 to 16/16

/// The paint byte of a colour (1 to 15) with a weight in sixteenths; 0 for no weight.
constexpr uint8_t paintByte(int color, int steps) {
    return steps > 0 ? uint8_t(color << 4 | (steps - 1)) : uint8_t(0);
}
/// The colour of a paint byte, 1 to 15; 0 if it is unpainted.
constexpr int paintColor(uint8_t paint) {
    return paint >> 4;
}
/// The weight of a paint byte in sixteenths, 1 to 16; 0 if it is unpainted.
constexpr int paintSteps(uint8_t paint) {
    return paint ? (paint & 15) + 1 : 0;
}

using Srgb = std::array<uint8_t, 3>;

/// Blends `paint` over an sRGB colour with a weight of `steps` sixteenths; shaders/lib/paint.glsl does the same.
constexpr Srgb paintOver(Srgb base, Srgb paint, int steps) {
    Srgb out{};
    for (size_t i = 0; i < 3; ++i)
        out[i] = uint8_t((base[i] * (kPaintSteps - steps) + paint[i] * steps + kPaintSteps / 2) / kPaintSteps);
    return out;
}

/// The squared distance of two colours in sRGB, 0 to 3 * 255^2.
constexpr int distanceSquared(const Srgb& a, const Srgb& b) {
    int sum = 0;
    for (size_t i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

/// The colours of a shape's paint layer. Immutable once a shape holds it: shapes share it, and a change makes a new
/// one.
struct PaintColors {
    std::array<Srgb, kPaintColors> colors{};  ///< colour c of a paint byte is colors[c - 1]
    uint8_t count = 0;                        ///< colours in use

    friend bool operator==(const PaintColors&, const PaintColors&) = default;
};
using PaintColorsRef = std::shared_ptr<const PaintColors>;  ///< null: nothing is painted

}  // namespace rubble
