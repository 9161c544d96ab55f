#pragma once
#include "runtime/world/level/level.h"

namespace rubble {

/// A pit of 8 x 8 m (body 0) and above it, in layers of 6 x 6, this many Voronoi pieces of about 64 to 600 voxels of
/// 0.1 m each, turned at random. pit: metres on a side.
Level voronoiPit(int pieces, uint64_t seed = 1, int pit = 8);

/// The same pit, and above it, in layers of 10 x 10, this many boxes of 5 x 5 x 5 voxels of 0.1 m, turned at random.
Level boxPit(int boxes);

}  // namespace rubble
