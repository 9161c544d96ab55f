#include "samples/scenes/palette_builder.h"

#include <algorithm>
#include <cassert>

#include "runtime/core/random.h"
#include "runtime/voxel/material.h"

namespace rubble::scenes {
namespace {

constexpr int kEntriesPerSwatch = 6;

// No surface is pure black or white: linear albedo 0.04 to 0.8 is sRGB 56 to 231; a single channel may be darker.
uint8_t channel(int value, bool emits) {
    return uint8_t(std::clamp(value, emits ? 0 : 28, emits ? 255 : 232));
}

}  // namespace

Palette PaletteBuilder::makeEmpty() {
    Palette palette{};
    palette[0].opacity = 0;
    return palette;
}

Swatch PaletteBuilder::addSurface(const SurfaceStyle& style, int percent, uint32_t lightGroup) {
    const uint8_t material = defaultMaterials().find(style.material);
    assert(material && "a style names a material that is not in the table");
    int colors = 0;
    while (colors < 4 && style.colors[size_t(colors)]) ++colors;
    assert(colors > 0 && "a style without a colour");
    const int count = style.variation == 0 ? colors : std::max(colors, kEntriesPerSwatch);
    assert(m_next + count <= 256 && "a shape's palette holds 255 entries");

    const Swatch swatch{uint8_t(m_next), uint8_t(count)};
    for (int i = 0; i < count; ++i) {
        const uint32_t color = style.colors[size_t(i % colors)];
        const uint32_t dice = hashCell(i, int(color), percent, 77);
        const int value = count == 1 || style.variation == 0
                              ? 100
                              : 100 + int(dice % uint32_t(2 * style.variation + 1)) - style.variation;
        const int warm = style.variation == 0 ? 0 : int(dice >> 16) % 5 - 2;
        const auto scaled = [&](int shift) { return int(color >> shift & 255) * value * percent / 10000; };
        PaletteEntry& entry = m_palette[size_t(m_next++)];
        const bool emits = style.emission > 0.0f;
        entry.red = channel(scaled(16) + warm, emits);
        entry.green = channel(scaled(8), emits);
        entry.blue = channel(scaled(0) - warm, emits);
        entry.opacity = style.opacity;
        entry.roughness = uint8_t(std::clamp(int(style.roughness) + int(dice >> 8 & 15) - 8, 5, 255));
        entry.metallic = style.metallic;
        entry.reflectivity = style.reflectivity;
        entry.material = material;
        entry.emission = style.emission;
        entry.lightGroup = lightGroup;
    }
    return swatch;
}

uint8_t PaletteBuilder::pick(Swatch swatch, glm::ivec3 cell) {
    // Clumps of about three voxels with jittered borders, so that they do not form a grid; one voxel in three is
    // random.
    const uint32_t own = hashCell(cell.x, cell.y, cell.z, 11);
    const int jitter = int(own >> 28 & 1);
    const uint32_t clump =
        hashCell((cell.x + jitter) / 3, (cell.y + int(own >> 27 & 1)) / 2, (cell.z + int(own >> 26 & 1)) / 3, 12);
    const uint32_t dice = own % 3 == 0 ? own >> 8 : clump >> 8;
    return uint8_t(swatch.first + dice % swatch.count);
}

}  // namespace rubble::scenes
