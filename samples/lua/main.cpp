// ./rubble lua: runs a script in a level for some steps, or reads lines of Lua.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "runtime/script/script_host.h"
#include "samples/lua/reference.h"
#include "samples/lua/yard.h"

namespace lua_sample {
namespace {

namespace fs = std::filesystem;
using rubble::script::Callback;
using rubble::script::kCallbacks;
using rubble::script::Script;
using rubble::script::ScriptHost;

struct Options {
    std::string script, level, vdbTool, reference;
    std::vector<std::string> evaluated, parameters;
    int steps = 600;
    bool prints = false;
};

std::string readFile(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// Lines of Lua from standard input, each in a step of its own: an expression, or statements.
int readLines(ScriptHost& host) {
    Script& script = host.add("line", "");
    for (std::string line; fmt::print("> "), std::fflush(stdout), std::getline(std::cin, line);) {
        std::string answer;
        const bool isExpression = script.compiles("return " + line);
        script.evaluate(isExpression ? "return " + line : line, answer);
        if (!answer.empty()) fmt::print("{}\n", answer);
        if (script.isStopped()) return 1;
        host.tick(1.0 / 60.0);
        host.step();
    }
    fmt::print("\n");
    return 0;
}

int evaluate(ScriptHost& host, const Options& options) {
    Script& script = host.add("eval", "");
    for (const std::string& text : options.evaluated) {
        std::string answer;
        if (!script.evaluate(script.compiles("return " + text) ? "return " + text : text, answer)) return 1;
        for (int i = 0; script.isWaiting() && i < options.steps; ++i) host.step();
        if (!answer.empty()) fmt::print("{}\n", answer);
        host.step();
    }
    return script.error().empty() ? 0 : 1;
}

void printProfile(const ScriptHost& host) {
    for (const Script& script : host.scripts())
        for (size_t i = 0; i < kCallbacks; ++i) {
            const auto& profile = script.profile(Callback(i));
            if (!profile.calls) continue;
            const double calls = double(profile.calls);
            fmt::print("{:<20} {:<12} {:>7} calls  {:>9.2f} us  {:>7.1f} allocations  {:>8.0f} instructions\n",
                       script.name(), nameOf(Callback(i)), profile.calls, 1e6 * profile.seconds / calls,
                       double(profile.allocations) / calls, double(profile.work) / calls);
        }
}

int play(ScriptHost& host, const Options& options) {
    std::map<std::string, std::string> parameters;
    for (const std::string& each : options.parameters)
        parameters[each.substr(0, each.find('='))] =
            each.find('=') == each.npos ? "1" : each.substr(each.find('=') + 1);
    const Script& script = host.add(fs::path(options.script).filename().string(), readFile(options.script), parameters);
    double due = 0.0;
    for (int i = 0; i < options.steps && !script.isStopped(); ++i) {
        host.tick(1.0 / 60.0);
        for (due += host.timeScale(); due >= 1.0; due -= 1.0) host.step();
    }
    if (options.prints) printProfile(host);
    return script.error().empty() ? 0 : 1;
}

int writeReference(const Options& options) {
    const std::string examples = fs::path(options.reference) / "../../samples/lua/examples.lua";
    fs::create_directories(options.reference);
    for (const auto& [name, page] : makeReference(examples)) std::ofstream(fs::path(options.reference) / name) << page;
    return 0;
}

int run(const Options& options) {
    if (!options.reference.empty()) return writeReference(options);
    const rubble_api* api = nullptr;
    rubble_world world = 0;
    rubble_world_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_WORLD_NO_RENDERER};
    std::string error;
    if (rubble_get_api(RUBBLE_VERSION, &api) != RUBBLE_OK) error = "this library is of another version";
    if (error.empty() && api->create_world(&settings, &world) != RUBBLE_OK) error = api->get_last_error();
    if (error.empty() && options.level.empty()) error = buildYard(*api, world);
    if (error.empty() && !options.level.empty() &&
        api->load_level(world, options.level.c_str(), options.vdbTool.c_str()) != RUBBLE_OK)
        error = api->get_last_error();
    if (!error.empty()) {
        fmt::print(stderr, "lua: {}\n", error);
        return 1;
    }
    int result = 0;
    {
        rubble::script::ScriptHostSettings given;
        given.folder = options.script.empty() ? "." : fs::absolute(options.script).parent_path().string();
        given.log = [](int level, const std::string& line) { fmt::print(level ? stderr : stdout, "{}\n", line); };
        ScriptHost host(*api, world, given);
        if (!options.evaluated.empty())
            result = evaluate(host, options);
        else
            result = options.script.empty() ? readLines(host) : play(host, options);
    }
    api->destroy_world(world);
    return result;
}

}  // namespace
}  // namespace lua_sample

int main(int argc, char** argv) {
    lua_sample::Options options;
    CLI::App app{"Runs a script in a level, without a window. Without a script: lines of Lua from standard input."};
    app.add_option("script", options.script, "a file of Lua")->check(CLI::ExistingFile);
    app.add_option("--level", options.level, "a .rubble, .vox or .vdb file; without it a small yard");
    app.add_option("--vdb-tool", options.vdbTool, "the program rubble-vdb, for .vdb levels");
    app.add_option("--steps", options.steps, "how long, in steps of 1/60 s");
    app.add_option("--eval", options.evaluated, "runs this text instead, and prints what it gives");
    app.add_option("--param", options.parameters, "NAME=VALUE, for GetIntParam() and its like");
    app.add_flag("--profile", options.prints, "prints what each callback has cost");
    app.add_option("--reference", options.reference, "writes the pages of docs/scripting into this folder");
    CLI11_PARSE(app, argc, argv);
    return lua_sample::run(options);
}
