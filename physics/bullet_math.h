#pragma once
#include <LinearMath/btTransform.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "runtime/core/pose.h"

namespace rubble {

inline btVector3 toBullet(glm::dvec3 v) {
    return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}
inline glm::dvec3 fromBullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
inline btMatrix3x3 toBullet(const glm::dquat& q) {
    const glm::dmat3 m = glm::mat3_cast(q);
    return {btScalar(m[0][0]), btScalar(m[1][0]), btScalar(m[2][0]), btScalar(m[0][1]), btScalar(m[1][1]),
            btScalar(m[2][1]), btScalar(m[0][2]), btScalar(m[1][2]), btScalar(m[2][2])};
}
inline glm::dquat fromBullet(const btMatrix3x3& m) {
    return glm::normalize(glm::quat_cast(glm::dmat3(m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2])));
}
/// World (double) to Bullet's frame, whose zero is at `origin`, and back.
inline btTransform toBullet(const Pose& world, glm::dvec3 origin) {
    return btTransform(toBullet(world.rotation), toBullet(world.position - origin));
}
inline Pose fromBullet(const btTransform& t, glm::dvec3 origin) {
    return {origin + fromBullet(t.getOrigin()), fromBullet(t.getBasis())};
}
inline Pose inverse(const Pose& pose) {
    const glm::dquat rotation = glm::conjugate(pose.rotation);
    return {-(rotation * pose.position), rotation};
}

}  // namespace rubble
