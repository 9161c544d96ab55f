#pragma once
#include "runtime/core/result.h"
#include "runtime/voxel/brick.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// Checks that a level is valid: numbers are finite, names are UTF-8, rotations have length 1, sizes are positive,
/// indices are in range. The error names the first bad field by its path ("bodies[1].pose.position"), what was expected
/// and what was found. Every reader and writer of level files calls it.
Result<Done> validateLevel(const Level& level);

}  // namespace rubble
