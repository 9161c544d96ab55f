// Shapes that are linked to files.
#include "editor/core/models.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/core/counted.h"

namespace editor {
namespace {

std::string describe(const std::string& file, const ModelReport& report) {
    std::string text = fmt::format("{}: {} brought up to date", file, rubble::counted(report.updated, "shape"));
    if (report.equal) text += fmt::format(", {} unchanged in the file", report.equal);
    const auto add = [&](const std::vector<std::string>& names, const char* what) {
        if (!names.empty()) text += fmt::format(", {} {}: {}", names.size(), what, listOf(names));
    };
    add(report.kept, "kept as edited here");
    add(report.locked, "kept as locked");
    add(report.gone, "no longer in the file");
    add(report.lostJoints, "lost of their joints");
    add(report.notRound, "no longer round, touched as voxels");
    add(report.otherVoxels, "kept, because its voxels have another size in the file");
    return text;
}

/// Those that are asked for, of the file that is asked for.
std::vector<LinkedShapes> wanted(Editor& editor, const Arguments& arguments) {
    std::vector<LinkedShapes> all =
        linkedShapes(editor.document(), editor.objects(arguments, "what", {RUBBLE_KIND_SHAPE}));
    if (!arguments.has("file")) {
        if (all.empty()) arguments.refuse("what", "shapes that are linked to files, found none");
        return all;
    }
    const std::string& file = arguments.text("file");
    const std::string path = modelPath(editor.document(), file);
    std::erase_if(all, [&](const LinkedShapes& each) { return each.source.path != path; });
    if (all.empty()) arguments.refuse("file", fmt::format("one to which shapes are linked, found '{}'", file));
    return all;
}

/// A file that cannot be read keeps no other from being read.
void reload(Editor& editor, const Arguments& arguments) {
    const std::vector<LinkedShapes> all = wanted(editor, arguments);
    std::vector<std::string> errors;
    for (const LinkedShapes& each : all) try {
            editor.say(describe(each.file, reloadModel(editor, each, arguments.flag("revert"))));
        } catch (const UnreadableModel& error) {
            errors.emplace_back(error.what());
        }
    if (errors.size() == all.size()) throw Refused(errors.front());
    for (const std::string& error : errors) editor.say(error);
}

void unlink(Editor& editor, const Arguments& arguments) {
    const size_t count = unlinkModels(editor.world(), editor.objects(arguments, "what", {RUBBLE_KIND_SHAPE}));
    if (!count) arguments.refuse("what", "shapes that are linked to files, found none");
    editor.say(rubble::counted(count, "shape") + " unlinked");
}

}  // namespace

std::vector<Command> modelCommands() {
    return {
        {"reload_models",
         "models",
         Kind::Edit,
         "Reads the files again from which shapes came: those that were not edited here become as they are there.",
         {{"file", Type::Text, "one of them, as the tag model_file says it; else all", kOptional, 0, 0,
           ".vox .vdb .rubble .obj .ply .glb"},
          {"what", Type::Objects, "the shapes", "all"},
          {"revert", Type::Flag, "whether those that were edited here become as they are there, too", "no"}},
         reload,
         "reload_models model.rubble"},
        {"unlink_models",
         "models",
         Kind::Edit,
         "Lets shapes forget the files from which they came.",
         {{"what", Type::Objects, "the shapes", "selected"}},
         unlink,
         "unlink_models all"},
    };
}

}  // namespace editor
