#include "editor/core/mesh_import.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <sstream>

#include "editor/core/arguments.h"
#include "editor/core/child_process.h"
#include "runtime/script/sandbox/script_name.h"

namespace editor {
namespace {

constexpr int kSeconds = 120;

/// The lines of an output that begin with a word, without it; other programs' control characters are left out.
std::vector<std::string> linesOf(const std::string& output, const std::string& word) {
    std::vector<std::string> lines;
    std::istringstream all(output);
    for (std::string line; std::getline(all, line);) {
        if (line.rfind(word, 0) != 0) continue;
        std::string text = line.substr(word.size());
        std::erase_if(text, [](unsigned char c) { return std::iscntrl(c); });
        lines.push_back(std::move(text));
    }
    return lines;
}

}  // namespace

using rubble::script::hasEnding;

bool isMeshFile(const std::string& path) {
    return hasEnding(path, ".obj") || hasEnding(path, ".ply") || hasEnding(path, ".glb");
}

std::vector<std::string> bakeMesh(const std::string& path, const std::string& output, const std::string& vdbTool,
                                  const MeshOptions& options) {
    std::vector<std::string> command{vdbTool,
                                     "--seconds",
                                     fmt::format("{}", kSeconds),
                                     "mesh-to-rubble",
                                     "--voxels",
                                     fmt::format("{}", options.voxels),
                                     "--voxel",
                                     fmt::format("{}", options.voxel),
                                     "--shell",
                                     fmt::format("{}", options.shell)};
    if (options.isZUp) command.emplace_back("--z-up");
    if (options.isSmooth) command.emplace_back("--smooth");
    command.push_back(path[0] == '-' ? "./" + path : path);
    command.push_back(output);
    const ChildResult result = runChild(command, kSeconds);
    if (result.isDone && std::filesystem::exists(output)) return linesOf(result.output, "note: ");
    const std::vector<std::string> errors = linesOf(result.output, "error: ");
    if (!errors.empty()) throw Refused(errors.front());
    const std::string end = result.isDone ? "wrote no level: is it the program rubble-vdb?" : result.end;
    throw Refused(fmt::format("{}: expected a mesh that can be read: rubble-vdb, a process of its own, {}", path, end));
}

}  // namespace editor
