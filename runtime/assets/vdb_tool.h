#pragma once
#include <string>
#include <vector>

#include "runtime/assets/assets.h"

namespace rubble {

/// Runs rubble-vdb under limits of memory (RUBBLE_VDB_MEMORY_MIB, 4096) and time (RUBBLE_VDB_SECONDS, 120) and returns
/// what it printed; an error with its own words if it failed, or with how it died.
Result<std::string> runVdbTool(const std::string& tool, const std::vector<std::string>& arguments);

/// readVdb() with the tool's notes in a report instead of the log.
Result<Level> readVdb(const std::string& path, const std::string& vdbTool, ImportReport* report);

/// Adds a level's shapes and voxels to a report.
void addLevelCounts(const Level& level, ImportReport& report);

}  // namespace rubble
