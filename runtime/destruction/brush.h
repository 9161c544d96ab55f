#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "runtime/voxel/material.h"

namespace rubble {

enum class BrushKind : uint8_t { Sphere, Box, Capsule };

/// A tool's volume in a shape's own cells, resolved to integers: positions and radii in 1/256 of a cell. The same brush
/// touches the same cells on every machine. A cell is touched if its centre is inside.
struct Brush {
    BrushKind kind = BrushKind::Sphere;
    std::array<int64_t, 3> a{};              ///< sphere: centre; capsule: one end; box: centre
    std::array<int64_t, 3> b{};              ///< capsule: other end; box: half sizes
    std::array<int32_t, 9> axes{};           ///< box: its unit axes (rows) in 1/65536
    std::array<int64_t, 3> radii{};          ///< soft, medium, hard: r0 >= r1 >= r2; box: how much each is grown or shrunk

    friend bool operator==(const Brush&, const Brush&) = default;
};

inline constexpr int64_t kBrushUnit = 256;   ///< steps of a cell

}  // namespace rubble
