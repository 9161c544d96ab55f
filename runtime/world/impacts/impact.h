#pragma once
#include <glm/vec3.hpp>

#include "runtime/core/handle.h"

namespace rubble {

/// A hard contact, as physics reports it.
struct Impact {
    BodyHandle body;
    BodyHandle other;          ///< empty: the ground around the level
    glm::dvec3 position{0.0};  ///< world
    glm::dvec3 normal{0.0};    ///< unit; the direction in which `body` is pushed
    double impulse = 0.0;      ///< N s
    double speed = 0.0;        ///< m/s at which they met
};

}  // namespace rubble
