#pragma once
#include <glm/gtc/quaternion.hpp>

#include "physics/collision/manifold.h"
#include "runtime/core/pose.h"

namespace rubble {

/// Where one body is in the frame of another: while that hardly changes, their contacts do not either and are only
/// moved along.
struct RelativePose {
    glm::dvec3 position{0.0};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
};
RelativePose relativePose(const Pose& first, const Pose& second);
/// The farthest that a point within `radius` metres of the first's origin may have moved against the second.
double maxPointDisplacement(const RelativePose& then, const RelativePose& now, double radius);

/// Notes where the manifold's points are on the two bodies.
void cacheContacts(Manifold& manifold, const Pose& first, const Pose& second);
/// Where the points of a manifold that was found at `then` are now.
void updateCachedContacts(Manifold& manifold, const RelativePose& then, const RelativePose& now, const Pose& first,
                          const Pose& second);

}  // namespace rubble
