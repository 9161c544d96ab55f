#pragma once
#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/used_entries.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

using Int128 = __int128;

/// The moments of mass of a set of voxels up to second order, in cells of a grid and in integers: exact and additive,
/// so the moments of two halves add up to those of the whole, bit for bit. Cell centres c + 1/2 are doubled to be
/// integers 2 c + 1; each voxel weighs its density in kg/m3.
struct MassMoments {
    int64_t voxels = 0;              ///< their number
    int64_t weight = 0;              ///< sum of densities
    std::array<int64_t, 3> first{};  ///< sum of density * (2 c + 1)
    std::array<Int128, 6> second{};  ///< sum of density * products of (2 c + 1): xx yy zz xy yz zx

    /// Adds one voxel.
    void add(glm::ivec3 cell, uint32_t density);
    MassMoments& operator+=(const MassMoments& other);
    MassMoments& operator-=(const MassMoments& other);
    /// The moments of the same voxels moved by `offset` cells: of a piece in the grid that it came from, or back.
    MassMoments shifted(glm::ivec3 offset) const;
    friend bool operator==(const MassMoments&, const MassMoments&) = default;
};

/// Density by palette entry, kg/m3.
struct Densities {
    std::array<uint32_t, 256> byEntry{};
    /// The densities of the materials of a palette.
    Densities(const Palette& palette, const MaterialTable& materials);
    /// A hash of the densities of some entries.
    uint64_t hashOf(const UsedEntries& entries) const;
};

/// The moments of a node's voxels in the node's own cells, for the densities that their entries had.
struct NodeMoments {
    UsedEntries entries;     ///< of its voxels, and maybe more
    uint64_t densities = 0;  ///< Densities::hashOf() these entries
    MassMoments sums;
    /// Whether they hold for a table: that of another palette may differ in entries that no voxel has.
    bool areFor(const Densities& table) const { return densities == table.hashOf(entries); }
};

/// [any-thread] The moments of a node's voxels, in cells of the grid. Cached in the node for the densities that came
/// first.
MassMoments nodeMoments(const BrickNode& node, glm::ivec3 nodePosition, const Densities& densities);
/// The moments of the solid voxels among `voxels` of a brick, in cells of the grid in which the brick is at
/// `brickPosition`.
MassMoments brickMoments(const Brick& brick, const BrickBits& voxels, glm::ivec3 brickPosition,
                         const Densities& densities);
/// The moments of all voxels of a grid.
MassMoments gridMoments(const VoxelGrid& grid, const Palette& palette, const MaterialTable& materials);

/// The mass properties of a rigid body, in the shape's frame.
struct MassProperties {
    double mass = 0.0;                             ///< kg
    glm::dvec3 center{0.0};                        ///< centre of mass, m
    glm::dvec3 principalInertia{0.0};              ///< about the centre, kg m2
    glm::dquat principalAxes{1.0, 0.0, 0.0, 0.0};  ///< principal frame -> shape frame
    /// Inertia tensor about the centre of mass in the shape's axes, kg m2: xx yy zz xy yz zx. The last three are the
    /// entries of the matrix: the negated products of inertia.
    std::array<double, 6> inertia{};
};

/// Mass properties from moments. Each voxel is a solid cube of side `voxelSize` metres.
MassProperties massProperties(const MassMoments& moments, double voxelSize);
/// Diagonalises a symmetric tensor (xx yy zz xy yz zx) by Jacobi rotations (G. Golub and C. Van Loan, Matrix
/// Computations, 8.5): `values` are its eigenvalues, `axes` turns the principal frame into that of the tensor.
void principalAxes(const std::array<double, 6>& tensor, glm::dvec3& values, glm::dquat& axes);

}  // namespace rubble
