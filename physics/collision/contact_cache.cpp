#include "physics/collision/contact_cache.h"

#include <cmath>

namespace rubble {

RelativePose relativePose(const Pose& first, const Pose& second) {
    const glm::dquat back = glm::conjugate(second.rotation);
    return {back * (first.position - second.position), glm::quat(back * first.rotation)};
}

/// The distance of two unit quaternions an angle apart is 2 sin(angle / 4). A point at `radius` moves by
/// 2 radius sin(angle / 2), which is at most 2 radius times that distance.
double maxPointDisplacement(const RelativePose& then, const RelativePose& now, double radius) {
    const float sign = glm::dot(then.rotation, now.rotation) < 0.0f ? -1.0f : 1.0f;
    const glm::quat chord = now.rotation - then.rotation * sign;
    return glm::length(now.position - then.position) + 2.0 * radius * double(std::sqrt(glm::dot(chord, chord)));
}

void cacheContacts(Manifold& manifold, const Pose& first, const Pose& second) {
    const glm::mat3 toFirst = glm::mat3_cast(glm::quat(glm::conjugate(first.rotation))),
                    toSecond = glm::mat3_cast(glm::quat(glm::conjugate(second.rotation)));
    for (ManifoldPoint& point : manifold.all()) {
        point.anchorInFirst = toFirst * (point.position + point.normal * (0.5f * point.separation));
        point.normalInSecond = toSecond * point.normal;
        point.cachedSeparation = point.separation;
    }
}

void updateCachedContacts(Manifold& manifold, const RelativePose& then, const RelativePose& now, const Pose& first,
                          const Pose& second) {
    const glm::mat3 deltaRotation = glm::mat3_cast(now.rotation) - glm::mat3_cast(then.rotation);
    const glm::mat3 fromFirst = glm::mat3_cast(glm::quat(first.rotation)),
                    fromSecond = glm::mat3_cast(glm::quat(second.rotation));
    const glm::vec3 deltaPosition(now.position - then.position);
    manifold.origin = first.position;
    for (ManifoldPoint& point : manifold.all()) {
        point.separation = point.cachedSeparation +
                           glm::dot(point.normalInSecond, deltaPosition + deltaRotation * point.anchorInFirst);
        point.normal = fromSecond * point.normalInSecond;
        point.position = fromFirst * point.anchorInFirst - point.normal * (0.5f * point.separation);
        point.isPressed = pressesOn(point);
    }
}

}  // namespace rubble
