#pragma once
#include <functional>
#include <glm/vec3.hpp>

#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// Palettes for .vdb files that bring none.

/// One grey entry of concrete, number 1.
PaletteRef grayFallbackPalette();
/// MagicaVoxel's default colours, with materials guessed for the entries that the grid uses.
PaletteRef voxFallbackPalette(const VoxelGrid& grid);
/// Gives each solid voxel an entry near its colour (linear RGB) and returns the palette: exact up to 255 colours,
/// with fewer bits a channel beyond.
PaletteRef quantiseColors(VoxelGrid& grid, const std::function<glm::vec3(glm::ivec3)>& colorAt);

}  // namespace rubble
