#pragma once
#include <array>
#include <cstdint>
#include <memory>

namespace rubble {

/// The paint layer: a byte beside a voxel's palette index, 0 = unpainted, else a colour of the shape (high four bits, 1
/// to 15) and how far the voxel's own colour has gone toward it (low four bits: 0 to 15 are 1/16 to 16/16 of the way).
inline constexpr int kPaintColors = 15;
inline constexpr int kPaintSteps = 16;

constexpr uint8_t paintByte(int color, int steps) {
    return steps > 0 ? uint8_t(color << 4 | (steps - 1)) : uint8_t(0);
}
/// 1 to 15; 0 = unpainted.
constexpr int paintColor(uint8_t paint) {
    return paint >> 4;
}
/// Sixteenths of the way, 0 to 16.
constexpr int paintSteps(uint8_t paint) {
    return paint ? (paint & 15) + 1 : 0;
}

using Srgb = std::array<uint8_t, 3>;

/// The colours of a shape's paint layer. Never changed once a shape holds it: pieces share it, a change makes a new
/// one.
struct PaintColors {
    std::array<Srgb, kPaintColors> colors{};  ///< colour c of a paint byte is colors[c - 1]
    uint8_t count = 0;                        ///< how many are in use

    friend bool operator==(const PaintColors&, const PaintColors&) = default;
};
using PaintColorsRef = std::shared_ptr<const PaintColors>;  ///< null: nothing is painted

}  // namespace rubble
