#include "runtime/assets/assets.h"

#include <filesystem>

#include "runtime/assets/vdb_tool.h"

namespace rubble {

void addLevelCounts(const Level& level, ImportReport& report) {
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) {
            ++report.shapes;
            report.voxels += shape.grid.voxelCount();
        }
    report.models = report.shapes;
}

Result<Level> readLevel(const std::string& path, const std::string& vdbTool, ImportReport* report) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (ending == ".vox") return importVox(path, {}, report);
    if (ending == ".vdb") return readVdb(path, vdbTool, report);
    if (ending != ".rubble")
        return Error{path + ": expected a name ending in .rubble, .vdb or .vox, found '" + ending + "'"};
    Result<Level> level = readRubble(path);
    if (level && report) addLevelCounts(*level, *report);
    return level;
}

}  // namespace rubble
