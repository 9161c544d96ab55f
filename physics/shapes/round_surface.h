#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"
#include "runtime/world/objects/collision_shape.h"

namespace rubble {

/// The sphere or cylinder that a part of a collider is touched as, in cells of its grid.
struct RoundSurface {
    int axis = -1;  ///< of a cylinder; -1: a sphere
    glm::vec3 center{0.0f};
    float radius = 0.0f;
    float halfLength = 0.0f;  ///< of a cylinder
    uint8_t entry = 0;        ///< of the palette: of its outermost voxel, whose material it has
    /// The unit vector along a cylinder's axis; 0 for a sphere.
    glm::vec3 direction() const {
        glm::vec3 unit(0.0f);
        if (axis >= 0) unit[axis] = 1.0f;
        return unit;
    }
};

/// Voxels that may lie between a round surface and the hull of the cells.
inline constexpr float kMaxRoundGap = 1.0f;

/// The smallest surface of a kind around the solid cells of a grid, about the middle of their bounds. None if the kind
/// is Voxels, or if the cells are not that round: in some direction they leave more than kMaxRoundGap.
std::optional<RoundSurface> fitRoundSurface(const VoxelGrid& grid, const CellBox& bounds, CollisionShape kind);

}  // namespace rubble
