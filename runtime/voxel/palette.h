#pragma once
#include <array>
#include <cstdint>
#include <memory>

namespace rubble {

/// The appearance and material of a voxel. Colours are sRGB; other bytes are fractions of 255.
struct PaletteEntry {
    uint8_t red = 255, green = 255, blue = 255;
    uint8_t opacity = 255;
    uint8_t roughness = 230;
    uint8_t metallic = 0;
    uint8_t reflectivity = 10;  ///< of a dielectric at normal incidence: 10 is 4 %
    uint8_t material = 0;       ///< index into the world's MaterialTable; 0 = unused entry
    float emission = 0.0f;      ///< radiance as a multiple of the linear colour; 0 = does not emit
    uint32_t lightGroup = 0;    ///< slot of the light group that switches its emission, plus one; 0 = none

    friend bool operator==(const PaletteEntry&, const PaletteEntry&) = default;
};

/// The 255 entries of a shape; entry 0 is "empty". Immutable once a shape holds it: shapes share it, and a change makes
/// a new one.
using Palette = std::array<PaletteEntry, 256>;
using PaletteRef = std::shared_ptr<const Palette>;

/// A hash of all entries.
uint64_t hashPalette(const Palette& palette);
/// An sRGB byte as linear [0, 1] (IEC 61966-2-1).
float srgbToLinear(uint8_t value);
/// The nearest sRGB byte of a linear value, clamped to [0, 1] (IEC 61966-2-1).
uint8_t linearToSrgb(float value);

}  // namespace rubble
