#pragma once
#include <functional>
#include <glm/vec3.hpp>

#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

// Palettes for .vdb files without one.

/// A palette with entry 1 alone: grey concrete.
PaletteRef grayFallbackPalette();
/// MagicaVoxel's default colours, with guessed materials, for the entries that the grid uses.
PaletteRef voxFallbackPalette(const VoxelGrid& grid);
/// What became of the colours of voxels.
struct ColorCounts {
    size_t found = 0, entries = 0;
    int error = 0;  ///< the largest difference of a channel, in 1/255
};
/// Gives each solid voxel the entry of its colour, colorAt(cell) as sRGB bytes 0xrrggbb, and returns the palette. More
/// than 255 different colours are parted into 255 groups with small differences, each with the mean of its colours, or
/// near it: no error is larger than half of the largest difference within a group.
PaletteRef quantiseColors(VoxelGrid& grid, const std::function<uint32_t(glm::ivec3)>& colorAt,
                          ColorCounts* counts = nullptr);
/// A linear colour as sRGB bytes 0xrrggbb.
uint32_t packSrgb(glm::vec3 linear);

}  // namespace rubble
