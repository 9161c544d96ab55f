#pragma once
#include <span>

#include "physics/shapes/voxel_collider.h"

namespace rubble {

/// An upper bound of the angle between two rotations, radians.
double largestAngle(const glm::dquat& from, const glm::dquat& to);

/// The path of a collider's frame through a step: its poses at equal intervals of time, two or more, with straight
/// lines and the shorter rotations between them.
struct SweptPose {
    std::span<const Pose> poses;
    /// The pose at a fraction of the step.
    Pose at(double fraction) const;
};

/// The fraction of the step at which a voxel of one collider enters a voxel of the other, 0 to 1; above 1: none does.
/// What is inside from the start does not count. axis: from the second to the first, along which they may be separated,
/// or 0. Both paths have as many poses, or one of them two. See time_of_impact.cpp for the method. [any thread]
double timeOfImpact(const VoxelCollider& first, const SweptPose& firstPath, const VoxelCollider& second,
                    const SweptPose& secondPath, const glm::vec3& axis = glm::vec3(0.0f));

}  // namespace rubble
