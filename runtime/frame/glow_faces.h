#pragma once
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/voxel/palette.h"
#include "runtime/world/objects/lights.h"

namespace rubble {

/// A connected set of voxels of one palette entry of a grid.
struct GlowingVoxels {
    const VoxelGrid& grid;    ///< that they are in
    const Palette& palette;   ///< of the grid
    double voxelSize;         ///< metres
    uint8_t entry;            ///< theirs
    const VoxelGrid& only;    ///< a grid with just the voxels of that entry
    const Component& voxels;  ///< in `only`
    glm::ivec3 corner{0};     ///< cell of `grid` at which cell 0 of `only` lies
};

/// Rectangles that shine as the faces do that no opaque voxel covers, in the shape's frame: one for each of the six
/// directions in which there are such faces, and each group of their planes (kPlaneGap). Radiance and area, and with
/// them the flux, are those of the faces; the rectangle lies in the outermost plane about their middle, with their
/// variance along both axes. Nothing for those below `minIntensity` (Light::color, of the brightest channel).
std::vector<Light> glowingFaces(const GlowingVoxels& glow, float minIntensity);

}  // namespace rubble
