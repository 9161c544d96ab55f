#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/destruction/brush.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// One step of a spray toward a colour.
struct Paint {
    std::array<uint8_t, 3> color{};  ///< sRGB
    uint8_t strength = 64;           ///< share of the way in one step, of 255; never less than eight steps of a byte
    uint8_t probability = 255;       ///< share of voxels touched at the rim, of 255; the middle is always touched
    uint32_t seed = 0;
};

struct Painted {
    std::vector<glm::ivec3> bricks;  ///< that changed, each once
    PaletteRef palette;              ///< the shape's new palette; null if it needs none
    uint64_t voxels = 0;
    uint64_t merges = 0;  ///< colours that found no free entry and took the nearest
};

/// Blends the colours of the voxels within a sphere that show a face to empty cells one step toward the paint. A voxel
/// changes its palette entry, never its material or anything but its colour. Blended colours take an equal or near entry
/// that differs in colour only, else a free one (unused entries are freed when none is left), else the nearest that is
/// closer to the paint. The last entries go to the paint itself, so that a full palette still reaches it.
Painted paint(VoxelGrid& grid, const PaletteRef& palette, const Brush& sphere, const Paint& paint);

}  // namespace rubble
