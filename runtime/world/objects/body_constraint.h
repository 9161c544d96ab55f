#pragma once
#include <glm/vec3.hpp>

#include "runtime/core/handle.h"

namespace rubble {

/// Holds one component of the velocity of a free body against another body for a step, with a limited force. Several of
/// them together hold a point, a rotation, or both.
struct BodyConstraint {
    BodyHandle body;
    BodyHandle other;           ///< that it is held against, and which bears the force; empty: the world
    glm::dvec3 position{0.0};   ///< world: the point of both bodies whose velocity it is; a turn has none
    glm::dvec3 direction{0.0};  ///< world, of any length but zero: along which the point moves, or about which it turns
    double speed = 0.0;         ///< of `body` against `other`, m/s or rad/s
    bool turns = false;         ///< it holds the angular velocity
    double minForce = 0.0;      ///< N or N m on `body` along the direction
    double maxForce = 0.0;      ///< both 0: no limit
};

}  // namespace rubble
