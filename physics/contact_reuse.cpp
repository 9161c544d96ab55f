#include "physics/contact_reuse.h"

#include <cmath>

namespace rubble {

RelativePlace relativePlace(const Pose& first, const Pose& second) {
    const glm::dquat back = glm::conjugate(second.rotation);
    return {back * (first.position - second.position), glm::quat(back * first.rotation)};
}

/// A chord of unit quaternions is 2 sin(angle / 4); a point at `radius` moves by 2 radius sin(angle / 2).
double wayBetween(const RelativePlace& then, const RelativePlace& now, double radius) {
    const float sign = glm::dot(then.rotation, now.rotation) < 0.0f ? -1.0f : 1.0f;
    const glm::quat chord = now.rotation - then.rotation * sign;
    return glm::length(now.position - then.position) + 2.0 * radius * double(std::sqrt(glm::dot(chord, chord)));
}

void anchor(Manifold& manifold, const Pose& first, const Pose& second) {
    const glm::mat3 toFirst = glm::mat3_cast(glm::quat(glm::conjugate(first.rotation))),
                    toSecond = glm::mat3_cast(glm::quat(glm::conjugate(second.rotation)));
    for (ManifoldPoint& point : manifold.all()) {
        point.onFirst = toFirst * (point.position + point.normal * (0.5f * point.separation));
        point.normalInSecond = toSecond * point.normal;
        point.separationThen = point.separation;
    }
}

void follow(Manifold& manifold, const RelativePlace& then, const RelativePlace& now, const Pose& first, const Pose& second) {
    const glm::mat3 turned = glm::mat3_cast(now.rotation) - glm::mat3_cast(then.rotation);
    const glm::mat3 fromFirst = glm::mat3_cast(glm::quat(first.rotation)), fromSecond = glm::mat3_cast(glm::quat(second.rotation));
    const glm::vec3 moved(now.position - then.position);
    manifold.origin = first.position;
    for (ManifoldPoint& point : manifold.all()) {
        point.separation = point.separationThen + glm::dot(point.normalInSecond, moved + turned * point.onFirst);
        point.normal = fromSecond * point.normalInSecond;
        point.position = fromFirst * point.onFirst - point.normal * (0.5f * point.separation);
    }
}

}  // namespace rubble
