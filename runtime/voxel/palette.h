#pragma once
#include <array>
#include <cstdint>
#include <memory>

namespace rubble {

/// How a voxel looks and what it is made of. Colours are sRGB; the other bytes are fractions of 255.
struct PaletteEntry {
    uint8_t red = 255, green = 255, blue = 255;
    uint8_t opacity = 255;
    uint8_t roughness = 230;
    uint8_t metallic = 0;
    uint8_t reflectivity = 10;  ///< of a dielectric, straight on: 10 is 4 %
    uint8_t material = 0;       ///< index into the world's MaterialTable; 0 = unused entry
    float emission = 0.0f;      ///< radiance as a multiple of the linear colour; 0 = gives no light
    uint32_t lightGroup = 0;    ///< slot of the light group that can darken it, plus one; 0 = none

    friend bool operator==(const PaletteEntry&, const PaletteEntry&) = default;
};

/// The 255 entries of a shape; entry 0 is "empty". Never changed once a shape holds it: shapes share it, a change makes
/// a new one.
using Palette = std::array<PaletteEntry, 256>;
using PaletteRef = std::shared_ptr<const Palette>;

uint64_t hashPalette(const Palette& palette);
/// sRGB byte -> linear [0, 1], and back (rounded), by table: IEC 61966-2-1.
float srgbToLinear(uint8_t value);
uint8_t linearToSrgb(float value);

}  // namespace rubble
