#include "runtime/assets/assets.h"

#include <algorithm>
#include <filesystem>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/rubble_file.h"
#include "runtime/assets/vox_import.h"

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

Result<Level> levelFromBytes(std::span<const uint8_t> bytes, const std::string& name) {
    const bool isRubble =
        bytes.size() >= kFileMagic.size() && std::equal(kFileMagic.begin(), kFileMagic.end(), bytes.begin(),
                                                        [](char a, uint8_t b) { return uint8_t(a) == b; });
    return isRubble ? levelFromRubble(bytes, name) : importVoxBytes(bytes, name, {});
}

}  // namespace rubble
