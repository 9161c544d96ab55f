#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string_view>

#include "runtime/voxel/palette.h"

namespace rubble::scenes {

/// The look and the material of a surface: up to four sRGB colours (0xrrggbb, 0 = unused), between which its voxels
/// vary.
struct SurfaceStyle {
    std::string_view material;
    std::array<uint32_t, 4> colors{};
    uint8_t roughness = 230;
    uint8_t metallic = 0;
    uint8_t reflectivity = 10;
    uint8_t opacity = 255;
    int variation = 6;  ///< brightness of single voxels varies by up to this many percent
    float emission = 0.0f;
};

/// Consecutive palette entries of one surface.
struct Swatch {
    uint8_t first = 0;
    uint8_t count = 0;
};

/// Builds the palette of one shape. Entries are assigned from 1 upward; unused ones remain free for paint.
class PaletteBuilder {
public:
    /// Adds the entries of a surface to the palette. `percent`: brightness of the whole surface (80 = darker, dirtier).
    /// `lightGroup`: index in Level::lightGroups plus one; 0 = none.
    Swatch addSurface(const SurfaceStyle& style, int percent = 100, uint32_t lightGroup = 0);
    /// The entry of a swatch at a cell; neighbouring cells tend to have the same one.
    static uint8_t pick(Swatch swatch, glm::ivec3 cell);
    /// The entry of a swatch for a numbered element: a brick, a board, a tile.
    static uint8_t pickFor(Swatch swatch, uint32_t element) { return uint8_t(swatch.first + element % swatch.count); }

    /// The palette so far.
    PaletteRef palette() const { return std::make_shared<Palette>(m_palette); }

private:
    Palette m_palette = makeEmpty();
    int m_next = 1;
    static Palette makeEmpty();
};

}  // namespace rubble::scenes
