#pragma once
#include <glm/gtc/quaternion.hpp>

#include "physics/collision/manifold.h"
#include "runtime/core/pose.h"

// While two bodies hardly move relative to each other, their contacts are not computed again but carried along: each
// keeps its anchor on the first body and its normal in the second, and its separation changes by the anchor's movement
// along the normal.

namespace rubble {

/// The pose of one body in the frame of another.
struct RelativePose {
    glm::dvec3 position{0.0};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
};
/// The pose of the first in the frame of the second.
RelativePose relativePose(const Pose& first, const Pose& second);
/// An upper bound, in metres, of how far a point within `radius` metres of the first's origin has moved relative to the
/// second.
double maxPointDisplacement(const RelativePose& then, const RelativePose& now, double radius);

/// Stores in each point where it is on the two bodies; call it when the contacts have been found.
void cacheContacts(Manifold& manifold, const Pose& first, const Pose& second);
/// Moves points that were found at the relative pose `then` to where they are now.
void updateCachedContacts(Manifold& manifold, const RelativePose& then, const RelativePose& now, const Pose& first,
                          const Pose& second);

}  // namespace rubble
