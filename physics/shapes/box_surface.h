#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "physics/shapes/solid_rows.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The box that a part of a collider is, in cells of its grid.
struct BoxSurface {
    glm::vec3 center{0.0f}, half{0.0f};  ///< its middle, and from there to its faces
    uint8_t entry = 0;                   ///< of the palette, of all its voxels; 0: they have several
};

/// The box that solid cells fill without a gap; none if there is a gap. rows: of the grid, in the tight bounds of its
/// solid cells.
std::optional<BoxSurface> findBoxSurface(const VoxelGrid& grid, const SolidRows& rows);

}  // namespace rubble
