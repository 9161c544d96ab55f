#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace rubble {

/// Takes the cells of a part to the world: corner + axes * cell, relative to the origin of the collider's frame. The
/// axes are orthogonal and as long as a voxel.
struct CellTransform {
    glm::dmat3 axes{1.0};    ///< of one cell, world axes, metres
    glm::dvec3 corner{0.0};  ///< of cell (0, 0, 0): from the collider's frame origin, world axes, metres
};

/// The inverse of the axes: from metres along the world's axes to cells.
inline glm::dmat3 metresToCells(const CellTransform& cells, double voxelSize) {
    return glm::transpose(cells.axes) / (voxelSize * voxelSize);
}

}  // namespace rubble
