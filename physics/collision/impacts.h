#pragma once
#include <span>
#include <vector>

#include "physics/collision/manifold.h"
#include "runtime/world/impacts/impact.h"
#include "runtime/world/world.h"

namespace rubble {

/// The velocity, m/s, of the fastest approach of the two bodies along a normal, among the points that they reach within
/// `seconds`; it points away from the second. Zero: they reach none.
glm::dvec3 approachVelocity(const Manifold& manifold, double seconds);

/// Where two bodies met in the last solve, world space, metres.
struct MeetingPoint {
    glm::dvec3 onFirst, onSecond;  ///< of each body, at the pose at which its contacts were found: these two met
    glm::dvec3 now;                ///< where the second one has it now
};

/// Where a point of the manifold came to touch. Its own position does not say it: a fast body may have contacts from
/// where it was at the start of the step.
MeetingPoint meetingPoint(const Manifold& manifold, const ManifoldPoint& point);

/// Where an object was when its contacts of this step were found.
Pose poseBeforeSolve(const CollisionObject& object);

/// Appends the impacts of the last solve: one for each pair of bodies, in the order of pairs, whose contacts closed
/// faster than minSpeed (m/s) and took more than `threshold` (N s) in all. handles: by body slot.
void findImpacts(std::span<Manifold* const> manifolds, double minSpeed, double threshold,
                 const std::vector<BodyHandle>& handles, std::vector<Impact>& out);

}  // namespace rubble
