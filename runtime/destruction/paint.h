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
    uint8_t strength = 64;      ///< blend weight of one step, in 1/255; at least 1/16, or 8 values of a palette colour
    uint8_t probability = 255;  ///< share of the voxels touched at the rim, in 1/255; in the centre all are
    uint32_t seed = 0;
    uint8_t falloff = 255;  ///< share of the strength at the rim, in 1/255
};

/// What a step of paint changed.
struct PaintResult {
    std::vector<glm::ivec3> bricks;  ///< that changed, each once
    PaletteRef palette;              ///< the shape's new palette; null if it needs none
    PaintColorsRef colors;           ///< the shape's new colours of its paint layer; null if it needs none
    uint64_t voxels = 0;             ///< that changed
    uint64_t merges = 0;             ///< colours that found no free entry and took the nearest one
};

/// Blends the colours of the exposed voxels within a brush one step toward the paint. A voxel gets another palette
/// entry that differs in colour only. That is an entry of an equal or nearly equal colour; else a free entry (unused
/// ones are freed when none is left); else the nearest one that is closer to the paint. The last free entries are kept
/// for the paint itself, so that it is reached in a full palette too. Falloff thins the spray: every touched voxel
/// takes a whole step.
PaintResult paintPalette(VoxelGrid& grid, const PaletteRef& palette, const Brush& brush, const Paint& paint);

/// The same in the paint layer (paint_colors.h): blend weights in sixteenths, for any palette. A voxel
/// with the colour of another paint changes to this one with a probability equal to the strength, so areas blend by
/// dithering. `colors`: the shape's; may be null. Where all 15 colours are in use, the nearest stands in.
PaintResult paintLayer(VoxelGrid& grid, const PaintColorsRef& colors, const Brush& brush, const Paint& paint);

/// One step on exactly these voxels, exposed or not, in the palette. Ignores Paint::probability and falloff. For
/// charring.
PaintResult paintPalette(VoxelGrid& grid, const PaletteRef& palette, std::span<const BrickSubset> cells,
                         const Paint& paint);
/// One step on exactly these voxels, exposed or not, in the paint layer. Ignores Paint::probability and falloff.
PaintResult paintLayer(VoxelGrid& grid, const PaintColorsRef& colors, std::span<const BrickSubset> cells,
                       const Paint& paint);

}  // namespace rubble
