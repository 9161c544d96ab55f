#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "runtime/core/pose.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// A point or a vector in a shape's cells, in steps of 2^-32 of a cell.
using FixedPoint = std::array<int64_t, 3>;
inline FixedPoint operator+(FixedPoint a, const FixedPoint& b) {
    for (size_t k = 0; k < 3; ++k) a[k] += b[k];
    return a;
}
inline FixedPoint operator*(FixedPoint a, int64_t times) {
    for (size_t k = 0; k < 3; ++k) a[k] *= times;
    return a;
}
/// The same numbers as doubles; exact within 2^20 cells.
inline std::array<double, 3> toDoubles(const FixedPoint& p) {
    return {double(p[0]), double(p[1]), double(p[2])};
}

/// Maps the world's shadow cells into a shape's cells, in fixed point: the same on every machine, and exactly affine
/// over the whole shape, so that all bricks of the volume see the same sample points.
///
/// The sampling rule: a shadow cell is set if one of its sample points lies in a solid voxel. A cell has one sample,
/// its centre, or n x n x n of them where voxels are smaller than cells, so that samples are no farther apart than a
/// voxel is wide. Two properties follow.
///
/// No light leaks: the cells along a ray share faces, so their samples are joined by steps no longer than a voxel, and
/// such steps cannot cross a wall that is one voxel thick, whatever its rotation.
///
/// No shape shadows itself: a sample of a set cell lies in the shape. If it is the centre, the cell extends at most
/// half its extent along the normal out of a face, with more samples at most all of it, and a ray that starts there
/// never meets it (surfaceOrigin() in shaders/lib/shadow_trace.glsl).
struct ShadowCellTransform {
    glm::ivec3 base{0};                ///< a shadow cell
    FixedPoint origin{};               ///< its first sample
    std::array<FixedPoint, 3> step{};  ///< between samples along each axis of the world
    int samples = 1;                   ///< per cell along each axis

    /// Sets it for a pose; lengths in metres. False if the pose holds a NaN or lies beyond 1e8 m: such a shape casts no
    /// shadow.
    bool place(const Pose& shapeToWorld, double voxelSize);
    /// The first sample of a shadow cell.
    FixedPoint sample(glm::ivec3 cell) const {
        FixedPoint p = origin;
        for (size_t a = 0; a < 3; ++a)
            for (size_t k = 0; k < 3; ++k) p[k] += (int64_t(cell[int(a)]) - base[int(a)]) * samples * step[a][k];
        return p;
    }
    /// Whether shadow cells are voxels, shifted: the shape is not rotated and its voxels have the size of cells.
    bool isShift() const;
};

/// A box that contains all shadow cells that a box of a shape's cells can set. ShadowCellTransform::place() must have
/// accepted the pose.
CellBox shadowBounds(const Pose& shapeToWorld, double voxelSize, glm::dvec3 lowLocal, glm::dvec3 highLocal);
/// The same for a box of whole cells.
inline CellBox shadowBounds(const Pose& shapeToWorld, double voxelSize, const CellBox& boxLocal) {
    return shadowBounds(shapeToWorld, voxelSize, glm::dvec3(boxLocal.low), glm::dvec3(boxLocal.high));
}

}  // namespace rubble
