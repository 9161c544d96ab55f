#pragma once
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// Writes the shapes of a level as a MagicaVoxel file, whole or not at all: an object each, several of at most 256
/// cells a side where it is larger, all with one palette. importVox() gives the same voxels, colours and materials
/// again. What such files cannot hold is a line of `lost`.
Result<Done> writeVox(const std::string& path, const Level& level, std::vector<std::string>& lost);

}  // namespace rubble
