#include "tests/architecture/include_graph.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string_view>

namespace rubble::architecture {
namespace {

namespace fs = std::filesystem;

/// A library, by the beginnings of its headers, and the folders that may include it.
struct Library {
    std::string_view name;
    std::vector<std::string> headers;
    std::vector<std::string> folders;
};

const std::vector<Library>& libraries() {
    static const std::vector<Library> table = {
        {"Bullet", {"bt", "Bullet", "LinearMath/"}, {"physics/", "tests/physics/", "tests/abi/layers/"}},
        {"OpenVDB",
         {"openvdb/", "nanovdb/", "tbb/", "OpenEXR/", "Imath/"},
         {"runtime/assets/vdb/", "tests/runtime/assets/vdb/", "tests/fuzz/vdb/", "tests/benchmark/openvdb/"}},
        {"Assimp", {"assimp/"}, {"runtime/assets/vdb/mesh_file.cpp"}},
        {"OpenGL", {"GL/", "GLES", "glad/", "KHR/"}, {"render/", "samples/support/", "samples/hosts/", "tests/"}},
        {"a window or a GL context",
         {"GLFW/", "EGL/", "GL/osmesa", "X11/"},
         {"samples/support/", "samples/sandbox/window.cpp", "samples/sandbox/shell/player_devices.cpp", "editor/"}},
        {"OpenAL", {"AL/"}, {"samples/sandbox/sound/output.cpp"}},
        {"libsndfile", {"sndfile.h"}, {"samples/sandbox/sound/wav_file.cpp"}},
        {"SDL", {"SDL"}, {"samples/hosts/sdl/", "samples/hosts/ogre/main.cpp"}},
        {"Ogre", {"Ogre"}, {"samples/hosts/ogre/"}},
        {"emscripten", {"emscripten"}, {"samples/hosts/web/"}},
        {"Lua", {"lua"}, {"runtime/script/", "tests/runtime/script/"}},
        {"libedit", {"editline/"}, {"samples/lua/line_input.cpp"}},
        {"FreeType", {"ft2build", "freetype"}, {"render/overlay/"}},
        {"Dear ImGui", {"imgui"}, {"editor/"}},
    };
    return table;
}

bool startsWithAny(std::string_view text, const std::vector<std::string>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const std::string& beginning) { return text.starts_with(beginning); });
}

/// The row of the table for a file: the one with the longest matching folder, or null.
const Module* moduleOf(std::string_view file, const std::vector<Module>& modules) {
    const Module* best = nullptr;
    for (const Module& module : modules)
        if (file.starts_with(module.folder) && (!best || module.folder.size() > best->folder.size())) best = &module;
    return best;
}

/// What stands between backticks in a cell of a Markdown table.
std::vector<std::string> quotedNames(const std::string& cell) {
    std::vector<std::string> names;
    for (size_t open = cell.find('`'); open != std::string::npos;) {
        const size_t close = cell.find('`', open + 1);
        if (close == std::string::npos) break;
        names.push_back(cell.substr(open + 1, close - open - 1));
        open = cell.find('`', close + 1);
    }
    return names;
}

constexpr std::array<std::string_view, 6> kFolders = {"runtime", "physics", "render", "shaders", "editor", "samples"};

std::vector<std::string> sourceFiles(const fs::path& root, bool withTests) {
    static const std::set<std::string> endings = {".h",    ".hpp",  ".inl",  ".c",   ".cpp",
                                                  ".glsl", ".vert", ".frag", ".comp"};
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

void checkLibraries(const Include& include, std::vector<Violation>& found) {
    for (const Library& library : libraries())
        if (startsWithAny(include.target, library.headers) && !startsWithAny(include.file, library.folders)) {
            std::string text =
                "<" + include.target + "> is " + std::string(library.name) + ", which only these may include:";
            for (const std::string& folder : library.folders) text += " " + folder;
            found.push_back({include.file, include.line, text});
        }
}

/// GLSL names its files from shaders/ on.
std::string folderOf(const std::string& file) {
    const std::string folder = fs::path(file).parent_path().generic_string();
    return folder == "lib" || folder == "passes" || folder == "shared" ? "shaders/" + folder : folder;
}

/// A file of the project counts as quoted however it is written: <physics/x.h>, "physics/../physics/x.h".
Include toInclude(const fs::path& root, const std::string& file, int line, const std::string& target, bool quoted) {
    const std::string normal = fs::path(target).lexically_normal().generic_string();
    return {file, line, normal, quoted || fs::exists(root / normal)};
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
                includes.push_back(toInclude(root, file, line, match[2].str(), match[1].str() == "\""));
        }
    }
    return includes;
}

std::vector<Module> readModules(const fs::path& root) {
    std::vector<Module> modules;
    std::ifstream stream(root / "ARCHITECTURE.md");
    for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with("| `")) continue;
        const size_t second = line.find('|', 1);
        const size_t third = second == std::string::npos ? second : line.find('|', second + 1);
        if (third == std::string::npos) continue;
        const std::vector<std::string> folder = quotedNames(line.substr(0, second));
        if (folder.size() != 1 || !folder[0].ends_with('/')) continue;
        modules.push_back({folder[0], quotedNames(line.substr(second, third - second))});
        modules.back().mayInclude.push_back(folder[0]);
    }
    return modules;
}

std::vector<Violation> checkModules(const std::vector<Include>& includes, const std::vector<Module>& modules) {
    std::vector<Violation> found;
    for (const Include& include : includes) {
        checkLibraries(include, found);
        if (include.file.starts_with("tests/")) continue;
        const Module* module = moduleOf(include.file, modules);
        if (!module) {
            found.push_back({include.file, include.line, "ARCHITECTURE.md has no row for this file's folder"});
        } else if (include.quoted && !startsWithAny(include.target, module->mayInclude)) {
            std::string text =
                "\"" + include.target + "\": by ARCHITECTURE.md, " + module->folder + " may include only:";
            for (const std::string& allowed : module->mayInclude) text += " " + allowed;
            found.push_back({include.file, include.line, text});
        }
    }
    return found;
}

std::vector<Violation> checkFolderCycles(const std::vector<Include>& includes) {
    std::map<std::string, std::map<std::string, const Include*>> edges;  // from folder to folder: the first such line
    for (const Include& include : includes) {
        const std::string from = folderOf(include.file), to = folderOf(include.target);
        if (include.quoted && from != to && !from.starts_with("tests")) edges[from].emplace(to, &include);
    }
    std::vector<Violation> found;
    std::map<std::string, int> state;  // 1: on the path, 2: done
    const std::function<void(const std::string&)> visit = [&](const std::string& folder) {
        state[folder] = 1;
        for (const auto& [next, include] : edges[folder]) {
            if (state[next] == 1)
                found.push_back(
                    {include->file, include->line, "closes a cycle of folders: " + next + " already needs " + folder});
            else if (state[next] == 0)
                visit(next);
        }
        state[folder] = 2;
    };
    std::vector<std::string> folders;
    for (const auto& [folder, targets] : edges) folders.push_back(folder);
    for (const std::string& folder : folders)
        if (state[folder] == 0) visit(folder);
    return found;
}

std::vector<Violation> checkNeverReaches(const std::vector<Include>& includes, const std::string& from,
                                         const std::string& to) {
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
            for (auto [it, end] = byFile.equal_range(file); it != end; ++it)
                open.push_back({it->second->target, chain + " > " + it->second->target});
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
            found.push_back({include.file, include.line,
                             "its own header \"" + own.generic_string() + "\" must be its first include"});
    }
    return found;
}

std::vector<Violation> checkNames(const fs::path& root) {
    static const std::set<std::string> top = {"runtime", "physics", "render", "shaders", "editor",
                                              "samples", "tests",   "docs",   "build",   "out"};
    static const std::set<std::string> vague = {"utils", "util", "common", "misc", "helpers"};
    static const std::regex vagueClass(R"(\b(class|struct)\s+\w*(Manager|Helper)\b)");
    std::vector<Violation> found;
    for (const auto& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory() && name[0] != '.' && !top.count(name))
            found.push_back({name, 0, "ARCHITECTURE.md knows no such folder at the top"});
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
