#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string_view>

#include "runtime/voxel/palette.h"

namespace rubble::scenes {

/// How one surface looks and what it is made of: up to four sRGB colours (0xrrggbb, 0 = unused) that its voxels vary
/// between.
struct SurfaceStyle {
    std::string_view material;
    std::array<uint32_t, 4> colors{};
    uint8_t roughness = 230;
    uint8_t metallic = 0;
    uint8_t reflectivity = 10;
    uint8_t opacity = 255;
    int variation = 6;  ///< percent of value up and down between neighbouring voxels
    float emission = 0.0f;
};

/// A run of neighbouring palette entries that make one surface.
struct Swatch {
    uint8_t first = 0;
    uint8_t count = 0;
};

/// Builds the palette of one shape. Entries are handed out from 1 upward; what is left over is free for spray paint.
class PaletteBuilder {
public:
    /// Mixes a surface into the palette. percent: value of the whole surface (80 = a darker, dirtier one).
    /// lightGroup: index in Level::lightGroups plus one.
    Swatch addSurface(const SurfaceStyle& style, int percent = 100, uint32_t lightGroup = 0);
    /// The entry of a swatch that belongs at a cell: in clumps, with single voxels that stray from theirs.
    static uint8_t pick(Swatch swatch, glm::ivec3 cell);
    /// The entry of a swatch for a thing with a number: a brick, a board, a tile.
    static uint8_t pickFor(Swatch swatch, uint32_t thing) { return uint8_t(swatch.first + thing % swatch.count); }

    int entriesUsed() const { return m_next - 1; }
    PaletteRef palette() const { return std::make_shared<Palette>(m_palette); }

private:
    Palette m_palette = makeEmpty();
    int m_next = 1;
    static Palette makeEmpty();
};

}  // namespace rubble::scenes
