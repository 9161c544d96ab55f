// Scripts that the level names: games run them, the editor does not.
#include <fmt/format.h>

#include <filesystem>

#include "editor/core/editor.h"
#include "runtime/script/sandbox/script_name.h"

namespace editor {
namespace {

namespace fs = std::filesystem;

/// A script as the level names it; the texts of rubble_level_script live as long as its step.
struct Named {
    std::string path, parameters;
};

std::vector<Named> scriptsOf(Editor& editor) {
    std::vector<Named> all;
    for (const rubble_level_script& each : editor.world().get_level_scripts())
        all.push_back({each.path, each.parameters});
    return all;
}

void setScripts(Editor& editor, const std::vector<Named>& scripts) {
    std::vector<rubble_level_script> rows;
    for (const Named& each : scripts) rows.push_back({each.path.c_str(), each.parameters.c_str()});
    editor.world().set_level_scripts(rows.data(), uint32_t(rows.size()));
}

void addScript(Editor& editor, const Arguments& arguments) {
    const std::string& file = arguments.text("file");
    const fs::path path(file);
    if (file.empty() || path.is_absolute() || file.find('\\') != file.npos || file.find("..") != file.npos)
        arguments.refuse("file", fmt::format("a path in the level's folder, found '{}'", file));
    if (!rubble::script::isScriptName(file))
        arguments.refuse("file", fmt::format("a name of one line that ends in .lua, found '{}'", file));
    std::vector<Named> scripts = scriptsOf(editor);
    scripts.push_back({file, arguments.text("parameters")});
    setScripts(editor, scripts);
    const std::string& level = editor.document().path();
    std::error_code wrong;
    if (!level.empty() && !fs::is_regular_file(fs::path(level).parent_path() / path, wrong))
        editor.say(fmt::format("there is no {} beside {} yet", file, fs::path(level).filename().string()));
}

void removeScript(Editor& editor, const Arguments& arguments) {
    const std::string& file = arguments.text("file");
    std::vector<Named> scripts = scriptsOf(editor);
    const size_t count = scripts.size();
    if (arguments.has("number")) {
        const size_t number = size_t(arguments.whole("number"));
        if (number > count || scripts[number - 1].path != file)
            arguments.refuse("number",
                             fmt::format("that of a script {}, as scripts lists them, found {}", file, number));
        scripts.erase(scripts.begin() + std::ptrdiff_t(number) - 1);
    } else {
        std::erase_if(scripts, [&](const Named& each) { return each.path == file; });
    }
    if (scripts.size() == count)
        arguments.refuse("file", fmt::format("a script that the level names, found '{}'", file));
    setScripts(editor, scripts);
}

void listScripts(Editor& editor, const Arguments&) {
    size_t number = 0;
    for (const Named& each : scriptsOf(editor)) {
        std::string line = fmt::format("{:4} {} ", ++number, each.path);
        for (const char letter : each.parameters) line += letter == '\n' ? ' ' : letter;
        editor.say(line.substr(0, line.find_last_not_of(' ') + 1));
    }
}

}  // namespace

std::vector<Command> scriptCommands() {
    const Parameter file{"file", Type::Text, "its path in the level's folder", kRequired};
    return {
        {"script_add",
         "scripts",
         Kind::Edit,
         "Lets the level name a script, which games run.",
         {file, {"parameters", Type::Pairs, "what GetIntParam() and its like read, as NAME=VALUE", ""}},
         addScript,
         "script_add lift.lua speed=2 height=6"},
        {"script_remove",
         "scripts",
         Kind::Edit,
         "Lets the level no longer name a script.",
         {file, {"number", Type::Whole, "which one, as scripts lists them; else all of that file", kOptional, 1, 1e4}},
         removeScript,
         "script_remove door.lua"},
        {"scripts", "scripts", Kind::View, "Lists the scripts that the level names.", {}, listScripts, "scripts"},
    };
}

}  // namespace editor
