#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/destruction/brush.h"
#include "runtime/destruction/components.h"
#include "runtime/voxel/paint_colors.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// One step of a spray toward a colour.
struct Paint {
    Srgb color{};
    uint8_t strength =
        64;  ///< share of the way in one step, of 255; never less than a sixteenth (a palette: eight steps of a byte)
    uint8_t probability = 255;  ///< share of voxels touched at the rim, of 255; in the middle all are
    uint32_t seed = 0;
    uint8_t falloff = 255;  ///< share of the strength that is left at the rim, of 255
};

struct PaintResult {
    std::vector<glm::ivec3> bricks;  ///< that changed, each once
    PaletteRef palette;              ///< the shape's new palette; null if it needs none
    PaintColorsRef colors;           ///< the shape's new colours of its paint layer; null if it needs none
    uint64_t voxels = 0;
    uint64_t merges = 0;  ///< colours that found no free entry and took the nearest
};

/// Blends the colours of the voxels within a brush that show a face to empty cells one step toward the paint. A voxel
/// changes its palette entry, never its material or anything but its colour. Blended colours take an equal or near
/// entry that differs in colour only, else a free one (unused entries are freed when none is left), else the nearest
/// that is closer to the paint. The last entries go to the paint itself, so that a full palette still reaches it.
/// Falloff thins the spray: every voxel that is touched takes the whole step.
PaintResult paintPalette(VoxelGrid& grid, const PaletteRef& palette, const Brush& brush, const Paint& paint);

/// The same in the paint layer beside the palette, in sixteenths of the way, whatever the palette holds. A voxel with
/// another paint's colour changes to this one with a chance of the step's size, so that areas of voxels blend. `colors`
/// may be null; where all 15 are taken by others, the nearest stands in.
PaintResult paintLayer(VoxelGrid& grid, const PaintColorsRef& colors, const Brush& brush, const Paint& paint);

/// One step at full strength on these voxels alone, exposed or not: charring. Paint's probability and falloff do
/// nothing.
PaintResult paintPalette(VoxelGrid& grid, const PaletteRef& palette, std::span<const BrickSubset> cells,
                         const Paint& paint);
PaintResult paintLayer(VoxelGrid& grid, const PaintColorsRef& colors, std::span<const BrickSubset> cells,
                       const Paint& paint);

/// An sRGB colour with some of the paint layer's sixteenths of another over it; shaders/lib/paint.glsl does the same.
Srgb paintOver(Srgb base, Srgb paint, int steps);

}  // namespace rubble
