#pragma once
#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// Whether a level makes sense: numbers finite, names UTF-8, rotations of length 1, sizes positive, indices in range.
/// Every reader and writer of level files calls it.
Result<Done> validateLevel(const Level& level);

}  // namespace rubble
