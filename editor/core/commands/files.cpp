// What is written for other programs.
#include <fmt/format.h>

#include <sstream>
#include <string>

#include "editor/core/editor.h"
#include "editor/core/mesh_export.h"
#include "editor/core/vdb_tool.h"
#include "runtime/core/counted.h"
#include "runtime/script/sandbox/script_name.h"

namespace editor {
namespace {

using rubble::script::hasEnding;

constexpr const char* kEndings = ".vox .obj .glb .rubble .vdb .png .json";

void requireEnding(const Arguments& arguments, const std::string& path) {
    std::istringstream words(kEndings);
    for (std::string ending; words >> ending;)
        if (hasEnding(path, ending.c_str())) return;
    arguments.refuse("file", fmt::format("a name that ends in one of: {}, found '{}'", kEndings, path));
}

void exportLevel(Editor& editor, const Arguments& arguments) {
    const std::string& path = arguments.text("file");
    requireEnding(arguments, path);
    const bool isImage = hasEnding(path, ".png"), isTrace = hasEnding(path, ".json");
    if (isImage || isTrace) {
        const auto& write = isImage ? editor.settings().writeView : editor.settings().writeTrace;
        if (!write)
            arguments.refuse("file", isImage ? "no image: only the window has a view"
                                             : "no trace: only the window measures its frames");
        if (const std::string error = write(path); !error.empty()) throw Refused(error);
        return editor.say("wrote " + path);
    }
    const bool isMesh = hasEnding(path, ".obj") || hasEnding(path, ".glb");
    if (!isMesh) {
        if (arguments.text("what") != "all")
            arguments.refuse("what", fmt::format("all, where the file is neither .obj nor .glb, found '{}'",
                                                 arguments.text("what")));
        if (path == editor.document().path())
            arguments.refuse("file", "another file than the level's own, which save writes");
        requireVdbTool(path, editor.settings().vdbTool);
        editor.world().save_level(path.c_str(), editor.settings().vdbTool.c_str());
        return editor.say("wrote " + path);
    }
    const MeshCounts counts = writeMeshes(editor.world(), editor.objects(arguments, "what", {RUBBLE_KIND_SHAPE}), path);
    editor.say(fmt::format("wrote {}: {}, {}", path, rubble::counted(counts.shapes, "shape"),
                           rubble::counted(counts.faces, "face")));
}

}  // namespace

std::vector<Command> fileCommands() {
    return {
        {"export",
         "session",
         Kind::View,
         "Writes a copy for other programs: .vox, .obj or .glb, .rubble or .vdb; .png: what the view shows; .json: a "
         "trace of its times.",
         {{"file", Type::Text, "its path, whose ending says the format", kRequired, 0, 0, kEndings},
          {"what", Type::Objects, "the shapes, of .obj and .glb", "all"}},
         exportLevel,
         "export crate.glb crate"},
    };
}

}  // namespace editor
