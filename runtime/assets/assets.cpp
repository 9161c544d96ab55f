#include "runtime/assets/assets.h"

#include <filesystem>

namespace rubble {

void ImportReport::count(const Level& level) {
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) {
            ++shapes;
            voxels += shape.grid.voxelCount();
        }
    models = shapes;
}

Result<Level> readLevel(const std::string& path, const std::string& vdbTool, ImportReport* report) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    if (ending == ".vox") return importVox(path, {}, report);
    if (ending == ".vdb") return readVdb(path, vdbTool, report);
    if (ending != ".rubble")
        return Error{(path.empty() ? "\"\"" : path) + ": expected a name ending in .rubble, .vdb or .vox, found '" +
                     ending + "'"};
    Result<Level> level = readRubble(path);
    if (level && report) report->count(*level);
    return level;
}

}  // namespace rubble
