#pragma once
#include <cstdint>

#include "runtime/destruction/brush.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The voxels of a brick with an empty neighbour, by the axis of that neighbour. A voxel may be in several of them.
struct ExposedBits {
    BrickBits x{}, y{}, z{};
    /// All exposed voxels.
    BrickBits all() const;
    /// The axis (0 to 2) of an exposed face of a voxel. Of several, z before y before x, so that neighbours in a wall
    /// or a roof have the same axis.
    int axis(int voxel) const;
};
/// The exposed voxels of the brick at `position`; its neighbours in the grid cover faces too.
ExposedBits exposedBits(const VoxelGrid& grid, glm::ivec3 position, const Brick& brick);

/// Blue noise on a surface whose faces are along `axis`: a threshold of 0 to 254 for each cell, each about equally
/// often. The cells below any threshold are spread evenly. The same on every machine.
int surfaceNoise(glm::ivec3 cell, int axis, uint32_t seed);

/// The squared distance of a cell's centre from the centre of a sphere or the axis of a capsule, in 1/255 of the square
/// of the brush's first radius, at most 255. 0 in a box.
int rimFraction(const Brush& brush, glm::ivec3 cell);

}  // namespace rubble
