#pragma once
#include <map>
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// A level without voxels as JSON texts by topic: name, palettes, materials, environment, light_groups, lights,
/// locations, bodies. gridNames: one a shape, in order; it stands as "grid" in the shape.
std::map<std::string, std::string> levelToJson(const Level& level, const std::vector<std::string>& gridNames);

struct JsonLevel {
    Level level;                         ///< grids empty, with their sizes
    std::vector<std::string> gridNames;  ///< one a shape, in order
};
/// What is missing keeps its default; what has the wrong type or range is an error with its path.
Result<JsonLevel> levelFromJson(const std::map<std::string, std::string>& topics);

}  // namespace rubble
