#include "editor/core/vdb_tool.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "editor/core/arguments.h"
#include "editor/core/mesh_import.h"
#include "runtime/script/sandbox/script_name.h"

namespace editor {

void requireVdbTool(const std::string& path, const std::string& vdbTool) {
    if (!isMeshFile(path) && !rubble::script::hasEnding(path, ".vdb")) return;
    std::error_code none;
    if (std::filesystem::is_regular_file(vdbTool, none) && access(vdbTool.c_str(), X_OK) == 0) return;
    const std::string found = vdbTool.empty() ? "none" : "no program at '" + vdbTool + "'";
    throw Refused(
        fmt::format("{}: expected the program rubble-vdb for it, found {}: --vdb-tool says where it is", path, found));
}

}  // namespace editor
