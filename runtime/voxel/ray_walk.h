#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// A ray in the grid's own cells: cell c covers [c, c + 1]. The direction need not be normalised; tMax is in its
/// lengths.
struct CellRay {
    glm::dvec3 origin;
    glm::dvec3 direction;
    double tMax;
};

struct CellHit {
    bool hit = false;
    glm::ivec3 cell{0};
    double t = 0.0;  ///< where the ray enters the cell; 0 if it starts inside; infinite if beyond any double
    int axis = -1;   ///< axis of the face entered through; -1 if it starts inside
    int sign = 0;    ///< +1 or -1: the face's outward normal along that axis
    int steps = 0;   ///< cells, bricks and nodes visited, at most nx + ny + nz + 3
};

/// The first solid voxel that the ray touches. Walks empty bricks and directory nodes in one step each, then cells (see
/// CellWalk for the rules on faces, edges and corners: the leaps change nothing). Zero components never divide; a NaN
/// anywhere, or an infinite origin or direction, gives no hit. A voxel entered exactly at tMax is hit. accepted:
/// palette entries that count; null: all.
CellHit walkRay(const VoxelGrid& grid, const CellRay& ray, const std::array<bool, 256>* accepted = nullptr);

}  // namespace rubble
