// ./rubble editor and ./rubble edit: commands on a level, without a window.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "editor/core/editor.h"

namespace editor {
namespace {

struct Options {
    std::string level, script, output, vdbTool, journals;
    std::vector<std::string> commands;
    bool lists = false, recovers = false, discards = false, isForced = false;
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

/// Runs the lines of standard input as they come, also after one that has failed; false: one has.
bool runInput(Editor& editor) {
    bool isDone = true;
    for (std::string line; std::getline(std::cin, line); std::fflush(stdout)) isDone = tell(editor.run(line)) && isDone;
    return isDone;
}

/// The folder of journals: none where a few commands run and nobody waits.
std::string journalsOf(const Options& options) {
    const bool isAsked = options.recovers || options.discards;
    return options.journals.empty() && isAsked ? userJournals() : options.journals;
}

int run(const Options& options) {
    if (options.lists) return listCommands();
    Editor editor({.vdbTool = options.vdbTool, .journals = journalsOf(options)});
    const auto call = [&](const char* command, const std::string& file) {
        return tell(editor.run(Line{command, {{"file", file}}}));
    };
    if (!options.level.empty() && !call("open", options.level)) return 1;
    if (options.recovers && !tell(editor.run(Line{"recover", {}}))) return 1;
    if (options.discards && !tell(editor.run(Line{"discard", {}}))) return 1;
    if (options.script == "-" && !runInput(editor)) return 1;
    if (!options.script.empty() && options.script != "-" && !tell(editor.runFile(options.script))) return 1;
    for (const std::string& line : options.commands)
        if (!tell(editor.run(line))) return 1;
    if (options.output.empty()) return 0;
    return tell(editor.run(Line{"save", {{"file", options.output}, {"force", options.isForced ? "yes" : "no"}}})) ? 0
                                                                                                                  : 1;
}

}  // namespace
}  // namespace editor

int main(int argc, char** argv) {
    editor::Options options;
    CLI::App app{"Makes and changes levels by commands. Its window: without --script, --run and -o."};
    app.add_option("level", options.level, "a .rubble, .vox or .vdb file; without it an empty level");
    app.add_option("commands", options.commands, "commands, each as one argument, as 'create 8,8,8 0,1,0'");
    app.add_option("--script", options.script,
                   "a file of commands, a line each, or of Lua; -: lines of standard input");
    app.add_option("-o,--output", options.output, "writes the level here: .rubble, .vdb or .vox");
    app.add_flag("--force", options.isForced, "also over a level that another program has written meanwhile");
    app.add_option("--journal", options.journals,
                   "a folder for what is done, until it is saved: --recover brings it back after a crash");
    app.add_flag("--recover", options.recovers,
                 "brings back what was not saved when an editor of the level ended early");
    app.add_flag("--discard", options.discards, "forgets that");
    app.add_option("--vdb-tool", options.vdbTool, "the program rubble-vdb, for .vdb files");
    app.add_flag("--list", options.lists, "lists all commands with their parameters");
    CLI11_PARSE(app, argc, argv);
    return editor::run(options);
}
