#pragma once
#include <functional>
#include <glm/gtc/quaternion.hpp>

namespace rubble {

/// How Bullet can turn a body on which nothing acts.
enum class BulletGyroscopy { None, Explicit, ImplicitInBody };

/// Takes the rotation and angular velocity (both in principal axes) of a rigid body of Bullet 1/60 s further in
/// substeps, each time the function is called.
std::function<void(glm::dquat&, glm::dvec3&)> bulletSpin(BulletGyroscopy mode, glm::dvec3 inertia, int substeps);

}  // namespace rubble
