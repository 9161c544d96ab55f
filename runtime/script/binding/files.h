#pragma once
#include <string>

#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {

/// A path of a mod without "MOD/", with which those of Teardown begin.
std::string withoutModFolder(const std::string& path);

/// Whether a path stays inside of a folder: no root, no "..", no backslash.
bool staysInside(const std::string& path);

/// Whether a path inside of a folder leads out of it by way of links, or nobody can tell.
bool leadsOutside(const std::string& folder, const std::string& path);

/// Whether a file is there that can be read to its end: no folder, pipe or device.
bool isFile(const std::string& path);

/// The path of a file of the folder that the host gives to scripts: argument `index` of the running function. Without a
/// folder, and for what leads out of it, an error.
std::string fileAt(lua_State* L, int index, const char* name);

}  // namespace rubble::script
