#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "physics/bodies/collision_object.h"
#include "physics/joints/rope_path.h"
#include "runtime/world/objects/joint.h"

namespace rubble {

/// What moves the points of a rope in a step.
struct RopeStep {
    double length = 0.0, radius = 0.0;              ///< metres
    std::array<std::optional<glm::dvec3>, 2> ends;  ///< where the held ends are after the step, world; none: free
    glm::dvec3 gravity{0.0};                        ///< m/s2
    double seconds = 1.0 / 60.0;
    std::span<CollisionObject* const> nearby;  ///< what the rope may touch
};

/// Moves the points of a rope through a step; see rope.cpp for the method. The points follow the bodies at the rope's
/// ends and do not pull them: that is JointSolver's, with one constraint along the path from end to end. bends:
/// replaced by the places at which the rope lies on something, from end 0 to end 1.
void moveRope(std::span<RopePoint> points, const RopeStep& step, std::vector<RopeBend>& bends);
/// The places at which a rope that does not move lies on something; `step` needs no time.
void findBends(std::span<const RopePoint> points, const RopeStep& step, std::vector<RopeBend>& bends);

}  // namespace rubble
