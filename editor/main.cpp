// ./rubble editor and ./rubble edit: commands on a level, with a window or without.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "editor/core/editor.h"
#include "editor/ui/host/scripted_ui.h"
#include "editor/ui/host/window.h"

namespace editor {
namespace {

struct Options {
    std::string level, script, output, vdbTool, journals, uiScript, screenshots, size = "1280x720", preset;
    std::vector<std::string> commands;
    bool lists = false, recovers = false, discards = false, isForced = false;

    /// Whether there is something to do without a window.
    bool isBatch() const { return !script.empty() || !output.empty() || !commands.empty() || recovers || discards; }
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
    if (!outcome.isDone) std::fflush(stdout);  // what went before stands before
    if (!outcome.text.empty()) fmt::print(outcome.isDone ? stdout : stderr, "{}\n", outcome.text);
    return outcome.isDone;
}

int fail(const std::string& error) {
    fmt::print(stderr, "rubble-editor: {}\n", error);
    return 1;
}

/// The interface without a display, driven by a script: images in a folder.
int drawImages(const Options& options) {
    int width = 0, height = 0, end = 0;
    if (sscanf(options.size.c_str(), "%4dx%4d%n", &width, &height, &end) != 2 || size_t(end) != options.size.size() ||
        width < 640 || height < 400 || width > 8192 || height > 8192)
        return fail("--size: expected WIDTHxHEIGHT from 640x400 to 8192x8192, found " + options.size);
    std::string text = options.level.empty() ? kShowcase : kLevelShowcase;
    if (!options.uiScript.empty()) {
        std::ostringstream read;
        read << std::ifstream(options.uiScript, std::ios::binary).rdbuf();
        text = read.str();
        if (text.find_first_not_of(" \t\r\n") == text.npos)
            return fail(options.uiScript + ": expected lines, found none");
    }
    if (const std::string error = folderError(options.screenshots); !error.empty())
        return fail("--screenshots: " + error);
    try {
        ScriptedUi ui({.vdbTool = options.vdbTool,
                       .journals = options.journals,
                       .preset = options.preset.empty() ? "draft" : options.preset,
                       .isForced = options.isForced},
                      width, height);
        ui.setFolder(options.screenshots);
        if (!options.level.empty() && !ui.stage().session().run("open", {{"file", options.level}}))
            return fail(ui.stage().session().messages().back().text);
        if (!options.level.empty()) ui.stage().session().frameSelection();
        const std::string error = ui.runAll(text, options.uiScript);
        return error.empty() ? 0 : fail(error);
    } catch (const std::exception& error) {
        return fail(error.what());
    }
}

int openWindow(const Options& options) {
    if (!hasDisplay())
        return fail(
            "the window needs a display, and DISPLAY and WAYLAND_DISPLAY are empty. Without one:\n"
            "  ./rubble editor LEVEL --script FILE -o OUT     runs commands\n"
            "  ./rubble editor LEVEL --screenshots FOLDER     draws images of the window\n"
            "  xvfb-run -a ./rubble editor LEVEL              gives it a display of its own (Debian package xvfb)");
    const std::string journals = options.journals.empty() ? userJournals() : options.journals;
    const std::string preset = options.preset.empty() ? "fast" : options.preset;
    const std::string error =
        runWindow({.vdbTool = options.vdbTool, .journals = journals, .preset = preset, .isForced = options.isForced},
                  options.level);
    return error.empty() ? 0 : fail(error);
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

/// The first argument is a level, or the first command on an empty one.
void takeFirstCommand(Options& options) {
    const std::string word = options.level.substr(0, options.level.find(' '));
    if (!findCommand(word) || std::filesystem::exists(options.level)) return;
    options.commands.insert(options.commands.begin(), options.level);
    options.level.clear();
}

/// A program that is beside this one; empty: nobody knows where this one is.
std::string programBeside(const char* name) {
    std::error_code error;
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::string() : (own.parent_path() / name).string();
}

int run(const Options& options) {
    if (options.lists) return listCommands();
    if (const std::string error = folderError(options.journals); !error.empty()) return fail("--journal: " + error);
    if (!options.screenshots.empty() || !options.uiScript.empty()) return drawImages(options);
    if (!options.isBatch()) return openWindow(options);
    Editor editor({.vdbTool = options.vdbTool, .journals = journalsOf(options), .isForced = options.isForced});
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
    return call("save", options.output) ? 0 : 1;
}

}  // namespace
}  // namespace editor

int main(int argc, char** argv) {
    editor::Options options;
    options.vdbTool = editor::programBeside("rubble-vdb");
    CLI::App app{
        "Makes and changes levels by commands. Opens its window unless there are commands to run or images to draw."};
    app.add_option("level", options.level, "a .rubble, .vox or .vdb file; without it an empty level");
    app.add_option(
        "commands", options.commands,
        "commands, each as one argument, as 'create 8,8,8 0,1,0'; the first may stand in place of the level");
    app.add_option("--script", options.script,
                   "a file of commands, a line each, or of Lua; -: lines of standard input");
    app.add_option("-o,--output", options.output, "writes the level here: .rubble, .vdb or .vox");
    app.add_flag("--force", options.isForced, "also over a level that another program has written meanwhile");
    app.add_option("--journal", options.journals,
                   "a folder for what is done, until it is saved: --recover brings it back after a crash");
    CLI::Option* const recover = app.add_flag("--recover", options.recovers,
                                              "brings back what was not saved when an editor of the level ended early");
    app.add_flag("--discard", options.discards, "forgets that")->excludes(recover);
    app.add_option("--vdb-tool", options.vdbTool,
                   "the program rubble-vdb, for .vdb files and meshes (default: the one beside this program)");
    app.add_option("--screenshots", options.screenshots,
                   "draws images of the window into this folder, without a display");
    app.add_option("--ui-script", options.uiScript,
                   "what is drawn there: a file of commands, and of lines that begin with ui")
        ->check(CLI::ExistingFile);
    app.add_option("--size", options.size, "of those images, WIDTHxHEIGHT in pixels");
    app.add_option("--preset", options.preset, "of the renderer: draft fast balanced accurate");
    app.add_flag("--list", options.lists, "lists all commands with their parameters");
    CLI11_PARSE(app, argc, argv);
    editor::takeFirstCommand(options);
    return editor::run(options);
}
