// ./rubble editor and ./rubble edit: commands on a level, without a window.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "editor/core/editor.h"

namespace editor {
namespace {

struct Options {
    std::string level, script, output, vdbTool;
    std::vector<std::string> commands;
    bool lists = false;
};

/// A parameter as the list of commands shows it.
std::string describe(const Parameter& parameter) {
    std::string text = fmt::format("    {:<14} {}", parameter.name, parameter.help);
    if (!parameter.choices.empty()) text += fmt::format(": {}", parameter.choices);
    if (parameter.otherwise == kRequired) return text + " (required)";
    return parameter.otherwise == kOptional ? text : text + fmt::format(" ({})", parameter.otherwise);
}

int listCommands() {
    std::string_view subject;
    for (const Command& command : allCommands()) {
        if (command.subject != subject) fmt::print("\n{}\n", subject = command.subject);
        fmt::print("  {:<16} {}\n", command.name, command.help);
        for (const Parameter& each : command.parameters) fmt::print("{}\n", describe(each));
        fmt::print("    e.g. {}\n", command.example);
    }
    return 0;
}

/// Prints what a step has to say; false: it has failed.
bool tell(const Outcome& outcome) {
    if (!outcome.text.empty()) fmt::print(outcome.isDone ? stdout : stderr, "{}\n", outcome.text);
    return outcome.isDone;
}

int run(const Options& options) {
    if (options.lists) return listCommands();
    Editor editor({.vdbTool = options.vdbTool});
    const auto call = [&](const char* command, const std::string& file) {
        return tell(editor.run(Line{command, {{"file", file}}}));
    };
    if (!options.level.empty() && !call("open", options.level)) return 1;
    if (!options.script.empty() && !tell(editor.runFile(options.script))) return 1;
    for (const std::string& line : options.commands)
        if (!tell(editor.run(line))) return 1;
    return options.output.empty() || call("save", options.output) ? 0 : 1;
}

}  // namespace
}  // namespace editor

int main(int argc, char** argv) {
    editor::Options options;
    CLI::App app{"Makes and changes levels by commands. Its window: without --script, --run and -o."};
    app.add_option("level", options.level, "a .rubble, .vox or .vdb file; without it an empty level");
    app.add_option("commands", options.commands, "commands, each as one argument, as 'create 8,8,8 0,1,0'");
    app.add_option("--script", options.script, "a file of commands, a line each, or of Lua")->check(CLI::ExistingFile);
    app.add_option("-o,--output", options.output, "writes the level here: .rubble or .vdb");
    app.add_option("--vdb-tool", options.vdbTool, "the program rubble-vdb, for .vdb files");
    app.add_flag("--list", options.lists, "lists all commands with their parameters");
    CLI11_PARSE(app, argc, argv);
    return editor::run(options);
}
