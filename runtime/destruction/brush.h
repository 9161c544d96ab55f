#pragma once
#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "runtime/voxel/brick.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/material.h"

namespace rubble {

/// The shape of a brush.
enum class BrushKind : uint8_t { Sphere, Box, Capsule };

/// The volume of a tool in the cells of a shape, in integers: positions and radii in 1/256 of a cell, so the same brush
/// touches the same cells on every machine. A cell is touched if its centre is inside. All kinds are convex.
struct Brush {
    BrushKind kind = BrushKind::Sphere;
    std::array<int64_t, 3> a{};      ///< sphere, box: centre; capsule: one end
    std::array<int64_t, 3> b{};      ///< capsule: other end; box: half extents
    std::array<int32_t, 9> axes{};   ///< box: its unit axes (rows) in 1/65536
    std::array<int64_t, 3> radii{};  ///< by Hardness, r0 >= r1 >= r2; box: by how much its half extents grow

    friend bool operator==(const Brush&, const Brush&) = default;
};

inline constexpr int64_t kBrushUnit = 256;                      ///< units of a cell
inline constexpr int64_t kBrushLimit = kBrushUnit << 18;        ///< coordinates and radii are clamped to +- this
inline constexpr int64_t kBrushEmptyRadius = -4 * kBrushLimit;  ///< a radius that touches no cell

/// A sphere from centre and radii in cells. A NaN touches nothing. A radius of zero or less touches nothing of its
/// hardness, and a harder class never gets a larger radius than a softer one.
Brush sphereBrush(glm::dvec3 center, std::array<double, 3> radii);
/// All cells within a radius of the segment from..to, by the rules of sphereBrush(). Cells.
Brush capsuleBrush(glm::dvec3 from, glm::dvec3 to, std::array<double, 3> radii);
/// An oriented box, in cells. `rotation`: from the box's frame to the shape's. `limit`: the hardest class it touches.
Brush boxBrush(glm::dvec3 center, glm::dvec3 halfSize, glm::dquat rotation, Hardness limit);

/// Whether a point (1/256 of a cell) is inside the brush of this radius, one of Brush::radii.
bool brushContains(const Brush& brush, std::array<int64_t, 3> point, int64_t radius);
/// The bricks that may hold touched cells, clipped to a grid of `sizeInBricks`.
CellBox brushBricks(const Brush& brush, glm::ivec3 sizeInBricks);
/// The cells of a brick that the brush touches with this radius, one of Brush::radii.
BrickBits brushBits(const Brush& brush, glm::ivec3 brick, int64_t radius);

}  // namespace rubble
