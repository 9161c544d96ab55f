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
/// Gives each solid voxel the entry of its colour, colorAt(cell) in linear RGB, and returns the palette. With more than
/// 255 different colours each channel loses low bits until 255 are left.
PaletteRef quantiseColors(VoxelGrid& grid, const std::function<glm::vec3(glm::ivec3)>& colorAt);

}  // namespace rubble
