#pragma once
#include <glm/vec3.hpp>

#include "physics/bodies/collision_object.h"

namespace rubble {

/// The displacement (metres, world axes) that takes a ball out of an object; zero: it does not touch it. Its centre
/// came from `before` to `center` and goes out by the faces through which it came in, however thin the object is. If it
/// was inside before, it goes out by the nearest face. See rope_contact.cpp.
glm::dvec3 exitDisplacement(const CollisionObject& object, glm::dvec3 before, glm::dvec3 center, double radius);
/// Metres from a place to the nearest face of an object that it is inside; 0: it is outside.
double depthInside(const CollisionObject& object, glm::dvec3 place);

}  // namespace rubble
