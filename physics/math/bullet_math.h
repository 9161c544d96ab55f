#pragma once
#include <LinearMath/btVector3.h>

#include <glm/vec3.hpp>

namespace rubble {

/// The vector as Bullet's floats. Subtract an origin nearby from world positions first: floats are coarse far away.
inline btVector3 toBullet(glm::dvec3 v) {
    return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}

}  // namespace rubble
