#pragma once
#include <glm/vec3.hpp>
#include <optional>

#include "physics/shapes/solid_rows.h"

namespace rubble {

/// The box that a part of a collider is, in cells of its grid.
struct BoxSurface {
    glm::vec3 center{0.0f}, half{0.0f};  ///< its middle, and from there to its faces
};

/// The box that solid cells fill without a gap; none if there is a gap. rows: in the tight bounds of the solid cells.
std::optional<BoxSurface> findBoxSurface(const SolidRows& rows);

}  // namespace rubble
