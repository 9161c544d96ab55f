#pragma once
#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

using Int128 = __int128;

/// Exact sums over the solid voxels of a shape, in its own cells: additive, so a split conserves them exactly.
/// Cell centres are doubled to stay integers (2 c + 1); weights are densities in kg/m3.
struct MassMoments {
    int64_t voxels = 0;
    int64_t weight = 0;              ///< sum of densities
    std::array<int64_t, 3> first{};  ///< sum of density * (2 c + 1)
    std::array<Int128, 6> second{};  ///< sum of density * products of (2 c + 1): xx yy zz xy yz zx

    void add(glm::ivec3 cell, uint32_t density);
    MassMoments& operator+=(const MassMoments& other);
    MassMoments& operator-=(const MassMoments& other);
    /// The same voxels in a grid whose cell 0 is this one's cell -offset (cells become cell + offset).
    MassMoments shifted(glm::ivec3 offset) const;
    friend bool operator==(const MassMoments&, const MassMoments&) = default;
};

/// The moments of what a node holds, in its own cells, for one table of densities.
struct NodeMoments {
    uint64_t densities = 0;  ///< a hash of the table
    MassMoments sums;
};
/// Density by palette entry, as integer sums need it.
struct Densities {
    std::array<uint32_t, 256> of{};
    uint64_t hash = 0;
    Densities(const Palette& palette, const MaterialTable& materials);
};

/// Of a whole node at its place in the grid. Worked out once a node and table of densities.
MassMoments nodeMoments(const BrickNode& node, glm::ivec3 nodePosition, const Densities& densities);
/// Over the solid voxels among `of`, of the brick at the given brick coordinate.
MassMoments brickMoments(const Brick& brick, const BrickBits& of, glm::ivec3 brickPosition, const Densities& densities);
MassMoments gridMoments(const VoxelGrid& grid, const Palette& palette, const MaterialTable& materials);

/// What a rigid body needs, from the moments. Metres and kilograms, in the shape's frame.
struct MassProperties {
    double mass = 0.0;
    glm::dvec3 center{0.0};
    glm::dvec3 principalInertia{0.0};              ///< about the centre, kg m2
    glm::dquat principalAxes{1.0, 0.0, 0.0, 0.0};  ///< principal frame -> shape frame
    std::array<double, 6>
        inertia{};  ///< tensor about the centre, shape frame: xx yy zz xy yz zx (products negated, as in the matrix)
};

/// Each voxel counts as a solid cube of side voxelSize metres.
MassProperties massProperties(const MassMoments& moments, double voxelSize);
/// Diagonalises a symmetric tensor (xx yy zz xy yz zx) by Jacobi rotations (Golub & Van Loan, 8.5).
void principalAxes(const std::array<double, 6>& tensor, glm::dvec3& values, glm::dquat& axes);

}  // namespace rubble
