#pragma once
#include <functional>
#include <glm/gtc/quaternion.hpp>

namespace rubble {

/// Bullet's methods of free rotation.
enum class BulletGyroscopy { None, Explicit, ImplicitInBody };

/// A function that rotates a rigid body by Bullet through 1/60 s. Rotation and angular velocity are in principal axes.
std::function<void(glm::dquat&, glm::dvec3&)> bulletSpin(BulletGyroscopy mode, glm::dvec3 inertia, int substeps);

}  // namespace rubble
