// ./rubble lua: runs a script in a level for some steps, or reads lines of Lua.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

#include "runtime/script/functions/vocabulary.h"
#include "runtime/script/script_host.h"
#include "samples/lua/line_input.h"
#include "samples/lua/offscreen_view.h"
#include "samples/lua/reference.h"
#include "samples/lua/yard.h"
#include "samples/support/number_option.h"
#include "samples/support/out_folder.h"

namespace lua_sample {
namespace {

namespace fs = std::filesystem;
constexpr uint32_t kWidth = 1280, kHeight = 720;  ///< pixels of an image
using rubble::script::Callback;
using rubble::script::kCallbacks;
using rubble::script::Script;
using rubble::script::ScriptHost;

struct Options {
    std::string script, level, vdbTool, reference, image;
    std::vector<std::string> evaluated, parameters;
    std::vector<double> camera;
    int steps = 600;
    bool hasSteps = false, prints = false, watches = false;
};

volatile std::sig_atomic_t interrupted = 0;

/// Ctrl+C ends a run in order, so that scripts get their destroy(); a second one ends it at once.
void catchInterrupts() {
    struct sigaction action = {};
    action.sa_handler = [](int) { interrupted = 1; };
    action.sa_flags = int(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
}

std::map<std::string, std::string> parametersOf(const Options& options) {
    std::map<std::string, std::string> parameters;
    for (const std::string& each : options.parameters)
        parameters[each.substr(0, each.find('='))] = each.substr(each.find('=') + 1);
    return parameters;
}

std::string readFile(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// Whether a text is the begin of an expression or of statements.
bool isBegin(Script& script, const std::string& text) {
    const std::string expression = "return " + text;
    return !script.compiles(expression) && (script.isBegin(text) || script.isBegin(expression));
}

/// The next expression or statements, which may have several lines; nothing: the input has ended.
std::optional<std::string> readStatements(LineInput& input, Script& script) {
    std::optional<std::string> text = input.read("> ");
    while (text && isBegin(script, *text)) {
        const std::optional<std::string> line = input.read(">> ");
        if (!line) break;
        *text += "\n" + *line;
    }
    return text;
}

/// A step with the callbacks of a frame, as hosts show it: after the step.
void playStep(ScriptHost& host, const OffscreenView* view) {
    host.tick(1.0 / 60.0);
    host.step();
    if (view) host.draw(view->renderer(), view->view(), 1.0 / 60.0);
}

/// Lua from standard input, each statement in a step of its own, or in as many as it waits.
void readLines(ScriptHost& host, const OffscreenView* view, const Options& options) {
    Script* script = &host.add("line", "", parametersOf(options));
    const char* home = std::getenv("HOME");
    LineInput input([&](std::string_view line) { return script->completions(line); },
                    std::string(home ? home : ".") + "/.rubble_lua_history");
    while (const std::optional<std::string> text = readStatements(input, *script)) {
        std::string answer;
        const bool isExpression = script->compiles("return " + *text);
        script->evaluate(isExpression ? "return " + *text : *text, answer);
        if (!answer.empty()) fmt::print("{}\n", answer);
        playStep(host, view);
        for (int i = 1; script->owesAnswer() && i < options.steps && !interrupted; ++i) playStep(host, view);
        const std::string late = script->takeAnswer();
        if (!late.empty()) fmt::print("{}\n", late);
        if (script->isStopped()) {
            fmt::print(stderr, "lua: the lines begin again: what they have defined is gone, what they did is not\n");
            host.scripts().remove_if([&](const Script& each) { return &each == script; });
            script = &host.add("line", "", parametersOf(options));
        }
        if (interrupted) break;
    }
    fmt::print("\n");
}

/// The text of --eval, which may wait; false: it has failed.
bool evaluateText(ScriptHost& host, Script& script, const OffscreenView* view, const Options& options,
                  const std::string& text) {
    std::string answer;
    if (!script.evaluate(script.compiles("return " + text) ? "return " + text : text, answer)) return false;
    for (int i = 0; script.isWaiting() && i < options.steps && !interrupted; ++i) playStep(host, view);
    answer += script.takeAnswer();
    if (!answer.empty()) fmt::print("{}\n", answer);
    if (!script.owesAnswer() || interrupted) return true;
    fmt::print(stderr, "lua: --eval: the text still waits after {} steps: see --steps\n", options.steps);
    return false;
}

bool evaluate(ScriptHost& host, const OffscreenView* view, const Options& options) {
    Script& script = host.add("eval", "", parametersOf(options));
    for (const std::string& text : options.evaluated) {
        if (!evaluateText(host, script, view, options, text)) return false;
        playStep(host, view);
    }
    while (options.hasSteps && host.shared().step < uint64_t(options.steps) && !interrupted) playStep(host, view);
    return true;
}

void printFunctions(const Script& script) {
    size_t index = 0;
    for (const rubble::script::Subject& subject : rubble::script::vocabulary())
        for (const rubble::script::ScriptFunction& function : subject.functions) {
            const uint64_t calls = script.context().calls[index];
            const rubble::script::FunctionCost& cost = script.context().costs[index++];
            if (calls)
                fmt::print("{:<20} {:<24} {:>7} calls  {:>9.2f} us  {:>7.1f} allocations\n", script.name(),
                           function.name(), calls, 1e6 * cost.seconds / double(calls),
                           double(cost.allocations) / double(calls));
        }
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
    for (const Script& script : host.scripts()) printFunctions(script);
}

/// Gives a script its file's text again when that has changed, or a file that it requires.
class FileWatch {
public:
    explicit FileWatch(std::string path) : m_path(std::move(path)) { isChanged(m_path); }
    void look(ScriptHost& host) {
        const std::string name = fs::path(m_path).filename().string();
        bool isDue = isChanged(m_path);
        for (const Script& script : host.scripts())
            if (script.name() == name)
                for (const std::string& path : script.context().required) isDue = isChanged(path) || isDue;
        if (isDue && host.reload(name, readFile(m_path))) fmt::print("{}: reloaded\n", name);
    }

private:
    /// Since the last look at it, of which the first one says no.
    bool isChanged(const std::string& path) {
        std::error_code missing;
        const fs::file_time_type now = fs::last_write_time(path, missing);
        if (missing) return false;  // an editor may be about to write it
        const auto [known, isNew] = m_times.try_emplace(path, now);
        return std::exchange(known->second, now) != now && !isNew;
    }
    std::string m_path;
    std::map<std::string, fs::file_time_type> m_times;
};

/// A frame: scripts see it as hosts show it, after its steps.
void playFrame(ScriptHost& host, const OffscreenView* view, double& due) {
    host.tick(1.0 / 60.0);
    for (due += host.timeScale(); due >= 1.0; due -= 1.0) host.step();
    if (view) host.draw(view->renderer(), view->view(), 1.0 / 60.0);
}

void play(ScriptHost& host, const OffscreenView* view, const Options& options) {
    FileWatch watch(options.script);  // before the script is read
    if (!options.script.empty())
        host.add(fs::path(options.script).filename().string(), readFile(options.script), parametersOf(options));
    double due = 0.0;
    const auto isOver = [&](int steps) {
        if (interrupted || (steps >= options.steps && (options.hasSteps || !options.watches))) return true;
        const std::list<Script>& scripts = host.scripts();
        return !options.watches && (scripts.empty() || (scripts.size() == 1 && scripts.front().isStopped()));
    };
    for (int i = 0; !isOver(i); i += i < options.steps) {
        playFrame(host, view, due);
        if (!options.watches) continue;
        watch.look(host);
        std::fflush(stdout);
        std::this_thread::sleep_for(std::chrono::milliseconds(16));
    }
}

/// How many scripts the level names that do not run: the log has said why.
size_t missingScripts(const rubble_api& api, rubble_world world, const ScriptHost& host) {
    uint32_t named = 0;
    api.get_level_scripts(world, nullptr, 0, &named);
    const auto running = std::count_if(host.scripts().begin(), host.scripts().end(),
                                       [](const Script& script) { return script.ofLevel().has_value(); });
    return size_t(std::max<ptrdiff_t>(0, ptrdiff_t(named) - running));
}

/// An option that would have no effect, or "".
std::string uselessOption(const Options& options, bool readsLines) {
    const bool onlyLevel = !readsLines && options.evaluated.empty() && options.script.empty();
    if (readsLines && options.hasSteps) return "--steps: expected a script, --eval or a level with scripts, found none";
    if (onlyLevel && !options.parameters.empty())
        return "--param: expected a script or --eval, found none: scripts of a level have parameters of their own";
    return "";
}

/// What the options ask for; false: a script has failed or is missing, or the image was not written.
bool runScripts(const rubble_api& api, rubble_world world, ScriptHost& host, OffscreenView* view,
                const Options& options) {
    host.shared().showsProfile = view && options.prints;
    host.addLevelScripts();
    const bool hasScripts = !host.scripts().empty() || missingScripts(api, world, host) > 0;
    const bool readsLines = options.evaluated.empty() && options.script.empty() && !hasScripts;
    std::string error = uselessOption(options, readsLines);
    if (!error.empty()) {
        fmt::print(stderr, "lua: {}\n", error);
        return false;
    }
    bool isGood = true;
    if (!options.evaluated.empty())
        isGood = evaluate(host, view, options);
    else if (readsLines)
        readLines(host, view, options);
    else
        play(host, view, options);
    if (options.prints) printProfile(host);
    if (view && host.shared().step == 0) host.step();  // a renderer shows nothing before the first one
    if (view) error = view->write(options.image);
    if (!error.empty()) fmt::print(stderr, "lua: {}\n", error);
    const bool hasFailed = std::any_of(host.scripts().begin(), host.scripts().end(),
                                       [](const Script& each) { return !each.error().empty(); });
    return isGood && error.empty() && missingScripts(api, world, host) == 0 && (readsLines || !hasFailed);
}

int writeReference(const Options& options) {
    const std::string examples = fs::path(options.reference) / "../../samples/lua/examples.lua";
    std::error_code wrong;
    fs::create_directories(options.reference, wrong);
    for (const auto& [name, page] : makeReference(examples)) {
        std::ofstream file(fs::path(options.reference) / name);
        file << page;
        if (file.flush()) continue;
        fmt::print(stderr, "lua: --reference: expected a folder that can be written, found {}\n", options.reference);
        return 1;
    }
    return 0;
}

int run(const Options& options) {
    if (!options.reference.empty()) return writeReference(options);
    const rubble_api* api = nullptr;
    rubble_world world = 0;
    rubble_world_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_WORLD_NO_RENDERER};
    std::string error;
    OffscreenView view;
    Camera camera;
    if (options.camera.size() == 6)
        std::copy_n(options.camera.data(), 3, camera.eye), std::copy_n(options.camera.data() + 3, 3, camera.target);
    double distance = 0.0;
    for (int i = 0; i < 3; ++i) distance = std::max(distance, std::abs(camera.target[i] - camera.eye[i]));
    if (!(distance > 1e-6 && distance < 1e9)) error = "--camera: expected two places that are not the same";
    if (!options.image.empty()) settings.flags = RUBBLE_WORLD_WAIT_FOR_SHADOW;
    if (error.empty() && rubble_get_api(RUBBLE_VERSION, &api) != RUBBLE_OK)
        error = "this library is of another version";
    if (error.empty() && !options.image.empty() && !(error = rubble::makeFolderOf(options.image)).empty())
        error = "--image: " + error;
    if (error.empty() && !options.image.empty()) error = view.open(*api, viewOf(camera, kWidth, kHeight));
    if (error.empty() && api->create_world(&settings, &world) != RUBBLE_OK) error = api->get_last_error();
    if (error.empty() && options.level.empty()) error = buildYard(*api, world);
    if (error.empty() && !options.level.empty() &&
        api->load_level(world, options.level.c_str(), options.vdbTool.c_str()) != RUBBLE_OK)
        error = api->get_last_error();
    if (error.empty() && !options.image.empty()) error = view.begin(world);
    if (!error.empty()) {
        fmt::print(stderr, "lua: {}\n", error);
        return 1;
    }
    int result = 0;
    {
        rubble::script::ScriptHostSettings given;
        const std::string& beside = options.script.empty() ? options.level : options.script;
        given.folder = beside.empty() ? "." : fs::absolute(beside).parent_path().string();
        if (!options.level.empty()) given.levelFolder = fs::absolute(options.level).parent_path().string();
        given.measuresFunctions = options.prints;
        bool isEnding = false;
        given.log = [&](int level, const std::string& line) {
            fmt::print(level ? stderr : stdout, "{}\n", line);
            if (isEnding && level >= RUBBLE_LOG_ERROR) result = 1;  // of destroy()
        };
        ScriptHost host(*api, world, given);
        host.setView(viewOf(camera, kWidth, kHeight));
        result = runScripts(*api, world, host, options.image.empty() ? nullptr : &view, options) ? 0 : 1;
        isEnding = true;
    }
    view.end();
    api->destroy_world(world);
    return result;
}

}  // namespace
}  // namespace lua_sample

int main(int argc, char** argv) {
    lua_sample::Options options;
    CLI::App app{"Runs a script in a level, without a window. Without a script: lines of Lua from standard input."};
    const auto fileError = [](const std::string& path) {
        std::error_code wrong;
        const bool isFile = std::filesystem::is_regular_file(path, wrong);
        return isFile && std::ifstream(path) ? std::string() : "expected a file that can be read, found " + path;
    };
    CLI::Option* script =
        app.add_option("script", options.script, "a file of Lua")->check(CLI::Validator(fileError, "FILE"));
    app.add_option("--level", options.level, "a .rubble, .vox or .vdb file; without it a small yard");
    std::error_code unknown;
    options.vdbTool = (std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / "rubble-vdb").string();
    app.add_option("--vdb-tool", options.vdbTool,
                   "the program rubble-vdb, for .vdb levels (default: the one beside this program)");
    const CLI::Option* steps =
        app.add_option("--steps", options.steps,
                       "how long, in steps of 1/60 s; with --watch until Ctrl+C without it; with --eval until the "
                       "text is done, which may wait for so long, 600 without it")
            ->check(CLI::Range(0, 1'000'000'000));
    app.add_option("--eval", options.evaluated,
                   "runs this text in place of a script, and prints what it gives; may be given several times")
        ->allow_extra_args(false)
        ->excludes(script);
    app.add_option("--param", options.parameters,
                   "NAME=VALUE, for GetIntParam() and its like, of the script, of --eval and of lines")
        ->allow_extra_args(false)
        ->check(CLI::Validator(
            [](const std::string& given) {
                const size_t at = given.find('=');
                return at == 0 || at == given.npos ? "expected NAME=VALUE, found " + given : std::string();
            },
            "NAME=VALUE"));
    app.add_flag("--profile", options.prints,
                 "prints what each callback and each function have cost; with --image: shows it too");
    app.add_flag("--watch", options.watches, "in real time; the script begins again when its file changes")
        ->needs(script);
    app.add_option("--image", options.image,
                   "writes the last frame, with what scripts draw, as PNG: of a script, --eval or lines");
    app.add_option("--camera", options.camera, "x y z of the camera, and of what it looks at, in metres")
        ->expected(6)
        ->check(rubble::numberFrom(-1e6, 1e6));
    const std::vector<CLI::Option*> others = app.get_options(
        [](const CLI::Option* each) { return !each->check_lname("vdb-tool") && !each->check_lname("help"); });
    CLI::Option* reference =
        app.add_option("--reference", options.reference, "writes the pages of docs/scripting into this folder");
    for (CLI::Option* other : others) reference->excludes(other);
    CLI11_PARSE(app, argc, argv);
    options.hasSteps = steps->count() > 0;
    lua_sample::catchInterrupts();
    return lua_sample::run(options);
}
