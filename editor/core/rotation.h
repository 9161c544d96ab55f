#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

namespace editor {

/// A rotation by degrees about x, then y, then z of the world.
inline glm::dquat rotationOf(glm::dvec3 degrees) {
    const glm::dvec3 half = glm::radians(degrees);
    return glm::angleAxis(half.z, glm::dvec3(0, 0, 1)) * glm::angleAxis(half.y, glm::dvec3(0, 1, 0)) *
           glm::angleAxis(half.x, glm::dvec3(1, 0, 0));
}

/// Into a field of rubble.h.
inline void put(double (&to)[4], const glm::dquat& from) {
    to[0] = from.x, to[1] = from.y, to[2] = from.z, to[3] = from.w;
}
/// Into a field of rubble.h.
inline void put(double (&to)[3], glm::dvec3 from) {
    for (int a = 0; a < 3; ++a) to[a] = from[a];
}
/// A position of rubble.h.
inline glm::dvec3 vectorOf(const double (&from)[3]) {
    return {from[0], from[1], from[2]};
}
/// A rotation of rubble.h.
inline glm::dquat quaternionOf(const double (&from)[4]) {
    return {from[3], from[0], from[1], from[2]};
}

}  // namespace editor
