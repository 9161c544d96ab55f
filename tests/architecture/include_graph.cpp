#include "tests/architecture/include_graph.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string_view>

namespace rubble::architecture {
namespace {

namespace fs = std::filesystem;

/// A room and what its files may include, both as beginnings of paths. The longest matching room counts.
struct Room {
    std::string_view path;
    std::vector<std::string_view> mayInclude;
};

// The arrows of the house, in one table. A room is listed in its own row too.
const std::vector<Room>& rooms() {
    static const std::vector<Room> table = {
        {"runtime/core/", {"runtime/core/"}},
        {"runtime/voxel/", {"runtime/core/", "runtime/voxel/"}},
        {"runtime/destruction/", {"runtime/core/", "runtime/voxel/", "runtime/destruction/"}},
        {"runtime/world/", {"runtime/core/", "runtime/voxel/", "runtime/destruction/", "runtime/world/"}},
        {"runtime/assets/", {"runtime/core/", "runtime/voxel/", "runtime/destruction/", "runtime/world/", "runtime/assets/"}},
        {"runtime/script/", {"runtime/core/", "runtime/voxel/", "runtime/destruction/", "runtime/world/", "runtime/script/"}},
        {"runtime/shadow/", {"runtime/core/", "runtime/voxel/", "runtime/destruction/", "runtime/world/", "runtime/shadow/"}},
        {"runtime/frame/", {"runtime/core/", "runtime/voxel/", "runtime/destruction/", "runtime/world/", "runtime/shadow/", "runtime/frame/"}},
        {"runtime/plugin/include/", {}},
        {"runtime/plugin/", {"runtime/", "physics/", "render/renderer.h"}},
        {"physics/", {"runtime/core/", "runtime/voxel/", "runtime/destruction/", "runtime/world/", "physics/"}},
        {"render/",
         {"runtime/core/", "runtime/voxel/", "runtime/world/lights.h", "runtime/world/frame_changes.h", "runtime/shadow/shadow_volume.h",
          "runtime/frame/frame_snapshot.h", "render/", "shaders/shared/"}},
        {"shaders/shared/", {"shared/", "shaders/shared/"}},  // GLSL names its files from shaders/
        {"shaders/lib/", {"shared/", "lib/"}},
        {"shaders/passes/", {"shared/", "lib/"}},
        {"samples/hello/", {"rubble/rubble.h"}},
        {"samples/hosts/", {"rubble/rubble.h", "samples/hosts/"}},
        {"samples/scenes/", {"runtime/core/", "runtime/voxel/", "runtime/destruction/", "runtime/world/", "runtime/assets/", "samples/scenes/"}},
        {"samples/support/", {"runtime/core/", "runtime/voxel/", "runtime/world/", "render/renderer.h", "samples/support/"}},
        {"samples/", {"runtime/", "physics/physics_world.h", "render/renderer.h", "render/gl/offscreen.h", "samples/"}},
        {"editor/", {"runtime/", "physics/physics_world.h", "render/renderer.h", "samples/support/", "editor/"}},
        {"tests/", {""}},
    };
    return table;
}

/// A library, by the beginnings of its headers, and the rooms behind whose wall it stays.
struct Wall {
    std::string_view name;
    std::vector<std::string_view> headers;
    std::vector<std::string_view> rooms;
};

const std::vector<Wall>& walls() {
    static const std::vector<Wall> table = {
        {"Bullet", {"bt", "Bullet", "LinearMath/"}, {"physics/", "tests/physics/"}},
        {"OpenVDB",
         {"openvdb/", "nanovdb/", "tbb/", "OpenEXR/", "Imath/"},
         {"runtime/assets/vdb/", "tests/runtime/assets/vdb/", "tests/benchmark/openvdb/"}},
        {"OpenGL", {"GL/", "GLES", "glad/", "KHR/"}, {"render/", "samples/support/", "tests/"}},
        {"a window or a GL context", {"GLFW/", "EGL/", "GL/osmesa", "X11/"}, {"samples/support/", "samples/sandbox/window.cpp", "editor/"}},
        {"Lua", {"lua"}, {"runtime/script/"}},
        {"Dear ImGui", {"imgui"}, {"editor/"}},
    };
    return table;
}

bool startsWithAny(std::string_view text, const std::vector<std::string_view>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(), [&](std::string_view beginning) { return text.starts_with(beginning); });
}

const Room* roomOf(std::string_view file) {
    const Room* best = nullptr;
    for (const Room& room : rooms())
        if (file.starts_with(room.path) && (!best || room.path.size() > best->path.size())) best = &room;
    return best;
}

constexpr std::array<std::string_view, 6> kFolders = {"runtime", "physics", "render", "shaders", "editor", "samples"};

std::vector<std::string> sourceFiles(const fs::path& root, bool withTests) {
    static const std::set<std::string> endings = {".h", ".hpp", ".c", ".cpp", ".glsl", ".vert", ".frag", ".comp"};
    std::vector<std::string> files;
    std::vector<std::string_view> folders(kFolders.begin(), kFolders.end());
    if (withTests) folders.push_back("tests");
    for (std::string_view folder : folders) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file() && endings.count(entry.path().extension().string()))
                files.push_back(fs::relative(entry.path(), root).generic_string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void checkWalls(const Include& include, std::vector<Violation>& found) {
    for (const Wall& wall : walls())
        if (startsWithAny(include.target, wall.headers) && !startsWithAny(include.file, wall.rooms)) {
            std::string text = "<" + include.target + "> is " + std::string(wall.name) + ", which only these may include:";
            for (std::string_view room : wall.rooms) text += " " + std::string(room);
            found.push_back({include.file, include.line, text});
        }
}

}  // namespace

std::vector<Include> readIncludes(const fs::path& root) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
    std::vector<Include> includes;
    for (const std::string& file : sourceFiles(root, true)) {
        std::ifstream stream(root / file);
        std::string text;
        for (int line = 1; std::getline(stream, text); ++line) {
            std::smatch match;
            if (text.find('#') != std::string::npos && std::regex_search(text, match, pattern))
                includes.push_back({file, line, match[2].str(), match[1].str() == "\""});
        }
    }
    return includes;
}

std::vector<Violation> checkArrows(const std::vector<Include>& includes) {
    std::vector<Violation> found;
    for (const Include& include : includes) {
        checkWalls(include, found);
        const Room* room = roomOf(include.file);
        if (!room) {
            found.push_back({include.file, include.line, "no room for this file in the table of arrows"});
        } else if (include.quoted && !startsWithAny(include.target, room->mayInclude)) {
            std::string text = "\"" + include.target + "\": " + std::string(room->path) + " may include only:";
            for (std::string_view allowed : room->mayInclude) text += " " + std::string(allowed);
            found.push_back({include.file, include.line, text});
        }
    }
    return found;
}

std::vector<Violation> checkNeverReaches(const std::vector<Include>& includes, const std::string& from, const std::string& to) {
    std::multimap<std::string, const Include*> byFile;
    for (const Include& include : includes)
        if (include.quoted) byFile.emplace(include.file, &include);
    std::vector<Violation> found;
    for (const Include& start : includes) {
        if (!start.quoted || !start.file.starts_with(from)) continue;
        std::set<std::string> seen;
        std::vector<std::pair<std::string, std::string>> open = {{start.target, start.target}};
        while (!open.empty()) {
            const auto [file, chain] = open.back();
            open.pop_back();
            if (file == to) found.push_back({start.file, start.line, "reaches " + to + ": " + chain});
            if (!seen.insert(file).second) continue;
            for (auto [it, end] = byFile.equal_range(file); it != end; ++it) open.push_back({it->second->target, chain + " > " + it->second->target});
        }
    }
    return found;
}

std::vector<Violation> checkOwnHeaderFirst(const fs::path& root, const std::vector<Include>& includes) {
    std::vector<Violation> found;
    std::string previous;
    for (const Include& include : includes) {
        if (include.file == previous) continue;
        previous = include.file;
        fs::path own = include.file;
        if (own.extension() != ".cpp") continue;
        own.replace_extension(".h");
        if (fs::exists(root / own) && include.target != own.generic_string())
            found.push_back({include.file, include.line, "its own header \"" + own.generic_string() + "\" must be its first include"});
    }
    return found;
}

std::vector<Violation> checkNames(const fs::path& root) {
    static const std::set<std::string> top = {"runtime", "physics", "render", "shaders", "editor", "samples", "tests", "build", "out"};
    static const std::set<std::string> vague = {"utils", "util", "common", "misc", "helpers"};
    static const std::regex vagueClass(R"(\b(class|struct)\s+\w*(Manager|Helper)\b)");
    std::vector<Violation> found;
    for (const auto& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory() && name[0] != '.' && !top.count(name)) found.push_back({name, 0, "the house has no such folder at the top"});
    }
    std::set<std::string> reported;
    for (const std::string& file : sourceFiles(root, true)) {
        for (const fs::path& part : fs::path(file).parent_path())
            if (vague.count(part.string()) && reported.insert(fs::path(file).parent_path().string()).second)
                found.push_back({file, 0, "a folder called " + part.string() + " says nothing about what is in it"});
        std::ifstream stream(root / file);
        std::string text;
        for (int line = 1; std::getline(stream, text); ++line)
            if (text.find("er") != std::string::npos && std::regex_search(text, vagueClass))
                found.push_back({file, line, "no class is called Manager or Helper: name what it does"});
    }
    return found;
}

}  // namespace rubble::architecture
