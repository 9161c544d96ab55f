#include "runtime/script/binding/files.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "runtime/script/binding/arguments.h"
#include "runtime/script/binding/script_context.h"

namespace rubble::script {
std::string withoutModFolder(const std::string& path) {
    constexpr std::string_view kModFolder = "MOD/";
    return path.starts_with(kModFolder) ? path.substr(kModFolder.size()) : path;
}

bool staysInside(const std::string& path) {
    return !path.empty() && path[0] != '/' && path.find('\\') == path.npos && path.find("..") == path.npos &&
           path.find('\0') == path.npos;
}

bool leadsOutside(const std::string& folder, const std::string& path) {
    std::error_code wrong;
    const auto inner = std::filesystem::weakly_canonical(folder + "/" + path, wrong);
    const auto outer = std::filesystem::weakly_canonical(folder, wrong);
    if (wrong) return true;
    return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first != outer.end();
}

bool isFile(const std::string& path) {
    std::error_code wrong;
    return std::filesystem::is_regular_file(path, wrong);
}

std::string fileAt(lua_State* L, int index, const char* name) {
    const std::string given = textAt(L, index, name), &folder = ScriptContext::of(L).folder;
    const std::string file = withoutModFolder(given);
    if (folder.empty() || !staysInside(file) || leadsOutside(folder, file))
        luaL_error(L, "%s: %s: expected a file inside of the folder that the host gives to scripts, found \"%s\"",
                   runningFunction(L).name().c_str(), name, given.c_str());
    std::string path = folder + "/" + file;
    std::error_code wrong;
    if (std::filesystem::exists(path, wrong) && !isFile(path))
        luaL_error(L, "%s: %s: expected a file, found something else under \"%s\"", runningFunction(L).name().c_str(),
                   name, given.c_str());
    return path;
}

}  // namespace rubble::script
