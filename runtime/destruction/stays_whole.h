#pragma once
#include "runtime/destruction/brick_set.h"

namespace rubble {

/// Whether all that borders on carved bricks still hangs together close by, through these bricks and their neighbours: then the
/// cut has taken nothing apart. False says nothing: what is apart here may meet farther away.
bool staysWhole(const VoxelGrid& grid, const BrickSet& carved);

}  // namespace rubble
