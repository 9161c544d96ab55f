#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/core/pose.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// From this size on, in metres, only the surface of a shape is rasterised: a voxel of 20 m holds 8 million shadow
/// cells, and no ray gets to those inside.
inline constexpr double kSurfaceVoxelSize = 0.8;
/// The most pieces of faces, of at most a shadow brick's side, that a shape's surface may have: 512 voxels of 20 m have
/// 65,000. A larger one casts no shadow.
inline constexpr double kMaxSurfaceTiles = 1 << 19;
/// The same while it moves, when all of them are built again in each step: a cube of 42 m. A larger one casts no shadow
/// until it rests.
inline constexpr double kMaxMovingTiles = 1 << 12;

/// Number of pieces of faces of at most a shadow brick's side that the surface of a shape's solid voxels has.
double surfaceTiles(const VoxelGrid& grid, double voxelSize);
/// Adds the shadow bricks that the surface of a shape's solid voxels can touch, some of them often. There are no more
/// than kMaxSurfaceTiles pieces of it, and ShadowCellTransform::place() has accepted the pose.
void listSurfaceBricks(const VoxelGrid& grid, const Pose& shapeToWorld, double voxelSize,
                       std::vector<glm::ivec3>& bricks);

}  // namespace rubble
