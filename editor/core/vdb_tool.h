#pragma once
#include <string>

namespace editor {

/// Throws Refused where a path is one that the program rubble-vdb reads or writes, .vdb or a mesh, and vdbTool is no
/// program that can be run. Of other paths it does nothing.
void requireVdbTool(const std::string& path, const std::string& vdbTool);

}  // namespace editor
