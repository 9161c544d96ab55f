#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// A ray in the cells of a grid: cell c covers [c, c + 1]. The direction need not be unit; tMax is in multiples of it.
struct CellRay {
    glm::dvec3 origin;
    glm::dvec3 direction;
    double tMax;
};

/// What a ray hits.
struct CellHit {
    bool hit = false;
    glm::ivec3 cell{0};
    double t = 0.0;  ///< where the ray enters the cell; 0 if it starts inside; infinite if no double is large enough
    int axis = -1;   ///< axis of the face entered through; -1 if it starts inside
    int sign = 0;    ///< +1 or -1: the face's outward normal along that axis
    int steps = 0;   ///< cells, bricks and nodes visited, at most nx + ny + nz + 3
};

/// [any-thread] The first solid voxel that the ray touches, among those whose palette entry is `accepted` (null: all).
/// A voxel entered exactly at tMax is hit. Zero components of the direction are safe; a NaN anywhere, or an infinite
/// origin or direction, gives no hit. CellWalk has the rules on faces, edges and corners.
CellHit walkRay(const VoxelGrid& grid, const CellRay& ray, const std::array<bool, 256>* accepted = nullptr);

}  // namespace rubble
