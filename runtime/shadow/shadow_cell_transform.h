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
/// Without loss, as long as it stays within 2^20 cells.
inline std::array<double, 3> toDoubles(const FixedPoint& p) {
    return {double(p[0]), double(p[1]), double(p[2])};
}

/// Maps the world's shadow cells into a shape's cells, in integers: the same everywhere, and exactly affine over the
/// whole shape, so that every brick of the volume is sampled from one cellTransform.
///
/// The rule: a cell is set if one of its sample points lies in a solid voxel. A cell has one sample, its centre; where
/// the voxels are smaller than cells, n x n x n samples that are no further apart than a voxel is wide. Nothing leaks:
/// a ray's cells share faces, so their samples can be joined in steps no longer than a voxel, and a wall one voxel
/// thick cannot be stepped over, however it is turned. And nothing shadows itself from half a cell's extent above its
/// face, where no cell of it (for voxels not smaller than cells) can reach.
struct ShadowCellTransform {
    glm::ivec3 base{0};                ///< a shadow cell
    FixedPoint origin{};               ///< its first sample
    std::array<FixedPoint, 3> step{};  ///< from one sample to the next along each axis of the world
    int samples = 1;                   ///< a cell, along each axis

    /// Position in metres, voxelSize in metres. False if the pose holds a NaN or lies beyond 1e8 m: such a shape casts
    /// no shadow.
    bool place(const Pose& shapeToWorld, double voxelSize);
    /// The first sample of a shadow cell, in voxels of the shape (32.32 fixed point).
    FixedPoint sample(glm::ivec3 cell) const {
        FixedPoint p = origin;
        for (size_t a = 0; a < 3; ++a)
            for (size_t k = 0; k < 3; ++k) p[k] += (int64_t(cell[int(a)]) - base[int(a)]) * samples * step[a][k];
        return p;
    }
    /// Not turned and of the cells' size: cells are voxels, shifted.
    bool isShift() const;
};

/// All shadow cells that a box of a shape's cells can set, and perhaps a few more. Its pose must have been placed.
CellBox shadowBounds(const Pose& shapeToWorld, double voxelSize, const CellBox& boxLocal);

}  // namespace rubble
