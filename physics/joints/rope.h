#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "physics/collision/broadphase.h"
#include "runtime/world/objects/joint.h"

namespace rubble {

/// What moves the points of a rope in a step.
struct RopeStep {
    double length = 0.0, radius = 0.0;              ///< metres
    std::array<std::optional<glm::dvec3>, 2> ends;  ///< where the ends are now, world; none: loose
    glm::dvec3 gravity{0.0};
    double seconds = 1.0 / 60.0;
    std::span<CollisionObject* const> near;  ///< what the rope may touch
};

/// Moves the points of a rope by position-based dynamics (Mueller et al. 2007): its segments only keep from getting
/// longer, and places along it are pushed out of voxels. The points updateCachedContacts the bodies at its ends and do
/// not pull them: JointSolver does that, with one constraint along the displacement from end to end. touching: the
/// places at which it lies on something, in order. Returns the fastest speed of a point, m/s.
double moveRope(std::span<RopePoint> points, const RopeStep& step, std::vector<glm::dvec3>& touching);

}  // namespace rubble
