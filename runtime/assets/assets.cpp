#include "runtime/assets/assets.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/rubble_file.h"
#include "runtime/assets/vox_export.h"
#include "runtime/assets/vox_import.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

Error wrongEnding(const std::string& path, const char* expected) {
    return Error{(path.empty() ? "\"\"" : path) + ": expected a name ending in " + expected + ", found '" +
                 endingOf(path) + "'"};
}

}  // namespace

std::string endingOf(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return ending;
}

void ImportReport::count(const Level& level) {
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) {
            ++shapes;
            voxels += shape.grid.voxelCount();
        }
    models = shapes;
}

Result<Level> readLevel(const std::string& path, const std::string& vdbTool, ImportReport* report) {
    const std::string ending = endingOf(path);
    if (ending == ".vox") return importVox(path, {}, report);
    if (ending == ".vdb") return readVdb(path, vdbTool, report);
    if (ending != ".rubble") return wrongEnding(path, ".rubble, .vdb or .vox");
    Result<Level> level = readRubble(path);
    if (level && report) report->count(*level);
    return level;
}

Result<Done> writeLevel(const std::string& path, const Level& level, const std::string& vdbTool) {
    const std::string ending = endingOf(path);
    if (ending == ".rubble") return writeRubble(path, level);
    if (ending == ".vdb") return writeVdb(path, level, vdbTool);
    if (ending == ".vox") {
        std::vector<std::string> lost;
        const Result<Done> written = writeVox(path, level, lost);
        for (const std::string& line : lost) logWarning(fmt::format("{}: not in the file: {}", path, line));
        return written;
    }
    return wrongEnding(path, ".rubble, .vdb or .vox");
}

Result<Level> levelFromBytes(std::span<const uint8_t> bytes, const std::string& name) {
    const bool isRubble =
        bytes.size() >= kFileMagic.size() && std::equal(kFileMagic.begin(), kFileMagic.end(), bytes.begin(),
                                                        [](char a, uint8_t b) { return uint8_t(a) == b; });
    return isRubble ? levelFromRubble(bytes, name) : importVoxBytes(bytes, name, {});
}

}  // namespace rubble
