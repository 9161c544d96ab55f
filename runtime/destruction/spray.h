#pragma once
#include <cstdint>

#include "runtime/destruction/brush.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The voxels of a brick that show a face to an empty cell, by the axis of such a face.
struct ExposedBits {
    BrickBits x{}, y{}, z{};
    BrickBits all() const;
    /// 0, 1, 2 of an exposed voxel: z before y before x, so that the other two axes number the voxels of a wall or
    /// roof.
    int axis(int voxel) const;
};
ExposedBits exposedBits(const VoxelGrid& grid, glm::ivec3 position, const Brick& brick);

/// A threshold for a cell of a surface with this axis, 0..254 about equally often, blue over the surface: any share of
/// cells chosen by it is spread evenly, without clumps. Seeded; the same everywhere.
int surfaceNoise(glm::ivec3 cell, int axis, uint32_t seed);

/// How far a cell's centre is from the middle of a sphere or from the axis of a capsule: the square of it, in 255ths of
/// the square of the brush's first radius. 0 in a box.
int rimFraction(const Brush& brush, glm::ivec3 cell);

}  // namespace rubble
