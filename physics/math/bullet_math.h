#pragma once
#include <LinearMath/btVector3.h>

#include <glm/vec3.hpp>

namespace rubble {

/// Rounds to floats: pass coordinates about an origin near by.
inline btVector3 toBullet(glm::dvec3 v) {
    return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}

}  // namespace rubble
