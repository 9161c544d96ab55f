#pragma once
#include <span>

#include "runtime/core/pose.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// How deep bodies are in each other, measured from the voxels alone.
struct Overlaps {
    size_t pairs = 0;   ///< that overlap at all
    double mean = 0.0;  ///< metres, of the deepest point of each such pair
    double median = 0.0, worst = 0.0;
    double high = 0.0;    ///< the highest centre of a dynamic body, metres
    double middle = 0.0;  ///< mean height of the dynamic bodies' centres
};

/// Points a quarter of a voxel apart all over the surface voxels of each body against the voxels of every other. How
/// deep a point is: its distance from the nearest cell of the other that is empty. Bodies of one shape each, at these
/// poses (of the bodies' frames, world).
Overlaps measureOverlaps(const Level& level, std::span<const Pose> poses);

}  // namespace rubble
