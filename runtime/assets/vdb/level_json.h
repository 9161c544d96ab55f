#pragma once
#include <map>
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// A level without its voxels as one JSON text for each top-level field ("name", "materials", "bodies", ...) and for
/// "palettes". gridNames: the prefix of each shape's grids, in the order of the shapes; stored as "grid" of the shape.
std::map<std::string, std::string> levelToJson(const Level& level, const std::vector<std::string>& gridNames);

/// What levelFromJson() reads.
struct JsonLevel {
    Level level;                         ///< its grids have their sizes and no voxels
    std::vector<std::string> gridNames;  ///< one for each shape, in order
};
/// Reads such texts. A missing field keeps its default; a wrong type or range is an error with the field's path.
Result<JsonLevel> levelFromJson(const std::map<std::string, std::string>& topics);

}  // namespace rubble
