#pragma once
#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "runtime/voxel/brick.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/material.h"

namespace rubble {

enum class BrushKind : uint8_t { Sphere, Box, Capsule };

/// A tool's volume in a shape's own cells, resolved to integers: positions and radii in 1/256 of a cell. The same brush
/// touches the same cells on every machine. A cell is touched if its centre is inside. All kinds are convex.
struct Brush {
    BrushKind kind = BrushKind::Sphere;
    std::array<int64_t, 3> a{};      ///< sphere: centre; capsule: one end; box: centre
    std::array<int64_t, 3> b{};      ///< capsule: other end; box: half sizes
    std::array<int32_t, 9> axes{};   ///< box: its unit axes (rows) in 1/65536
    std::array<int64_t, 3> radii{};  ///< soft, medium, hard: r0 >= r1 >= r2; box: how much each is grown or shrunk

    friend bool operator==(const Brush&, const Brush&) = default;
};

inline constexpr int64_t kBrushUnit = 256;                      ///< steps of a cell
inline constexpr int64_t kBrushLimit = kBrushUnit << 18;        ///< coordinates and radii are clamped to +- this
inline constexpr int64_t kBrushEmptyRadius = -4 * kBrushLimit;  ///< a radius that touches no cell

/// From positions and radii in cells (soft, medium, hard). The only places where a brush is rounded; a NaN touches
/// nothing, a radius of zero or less touches nothing of its class, and a harder class never gets more than a softer
/// one.
Brush sphereBrush(glm::dvec3 center, std::array<double, 3> radii);
Brush capsuleBrush(glm::dvec3 from, glm::dvec3 to, std::array<double, 3> radii);
/// `rotation`: box frame -> shape frame; `limit`: the hardest class that it touches.
Brush boxBrush(glm::dvec3 center, glm::dvec3 halfSize, glm::dquat rotation, Hardness limit);

/// Whether a point (1/256 of a cell) lies within the brush at one of its radii.
bool brushContains(const Brush& brush, std::array<int64_t, 3> point, int64_t radius);
/// The bricks that may hold touched cells, clipped to a grid of this many bricks.
CellBox brushBricks(const Brush& brush, glm::ivec3 sizeInBricks);
/// The cells of a brick that the brush touches at one of its radii.
BrickBits brushBits(const Brush& brush, glm::ivec3 brick, int64_t radius);

}  // namespace rubble
