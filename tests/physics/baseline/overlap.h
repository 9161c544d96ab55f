#pragma once
#include <span>

#include "runtime/core/pose.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// How deep bodies overlap, measured from the voxels alone.
struct Overlaps {
    size_t pairs = 0;   ///< that overlap
    double mean = 0.0;  ///< metres, of the deepest point of each such pair
    double median = 0.0, worst = 0.0;
    double high = 0.0;    ///< the highest centre of a dynamic body, metres
    double middle = 0.0;  ///< mean height of the dynamic bodies' centres
};

/// Compares points on the surface voxels of each body, a quarter of a voxel apart, with the voxels of every other. The
/// depth of a point is its distance from the other's nearest empty cell. The level's bodies must have one shape each.
/// poses: of the bodies' frames, world.
Overlaps measureOverlaps(const Level& level, std::span<const Pose> poses);

}  // namespace rubble
