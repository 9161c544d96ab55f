// ./rubble stress: scenarios of destruction, written in Lua, with everything checked at every step.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "runtime/script/sandbox/script_name.h"
#include "samples/stress/minimise.h"
#include "samples/stress/report.h"
#include "samples/stress/results.h"
#include "samples/support/number_option.h"
#include "samples/support/out_folder.h"
#include "samples/support/progress.h"

namespace stress {
namespace {

namespace fs = std::filesystem;

/// Bytes by which the heap may be larger after a run than before it: what libraries keep, 60 to 304 KiB.
constexpr int64_t kMaxHeapGrowth = 1 << 20;

constexpr double kMinMinutes = 0.001;

constexpr int kSignalled = 128;  ///< the exit code of shells, with the number of the signal

volatile std::sig_atomic_t interrupted = 0;  ///< by this signal

char recordings[2][4096];  ///< files of the run; names that are longer are not here

/// Ctrl+C, and SIGTERM, end a run after the step that it is in, and keep its figures. The next one ends the program.
void onSignal(int signal) {
    if (!interrupted) return void(interrupted = signal);
    for (const char* path : recordings) unlink(path);
    std::signal(signal, SIG_DFL);
    raise(signal);
}

void catchSignals() {
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

/// Files that a signal removes.
void setRecordings(const RunSettings& settings) {
    const std::string paths[] = {resultPath(settings, ".rubblelog"), resultPath(settings, ".rubblelog.part")};
    for (size_t i = 0; i < 2; ++i) {
        const bool fits = paths[i].size() < sizeof recordings[i];
        std::copy_n(paths[i].c_str(), fits ? paths[i].size() + 1 : 1, recordings[i]);
        if (!fits) recordings[i][0] = 0;
    }
}

struct Options {
    std::string scenario = "all", out = "out/stress", build;
    std::vector<uint64_t> seeds = {1};
    double minutes = 1.0 / 3.0, checkEvery = 4.0;
    int images = 3, minimiseRuns = 200, replayEvery = 1;
    bool lists = false, listsJobs = false, hasThreads = false;
};

/// What is wrong with the text of a seed, or "".
std::string seedError(const std::string& text) {
    uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc() && read.ptr == end ? "" : "expected a whole number below 2^64, found " + text;
}

std::string readFile(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// The text behind "-- " in the first line of a script.
std::string descriptionOf(const std::string& script) {
    const std::string line = script.substr(0, script.find('\n'));
    return line.starts_with("-- ") ? line.substr(3) : "";
}

int stepsOf(double minutes) {
    return std::max(1, int(minutes * 3600.0));
}

/// All scenarios, or the one that is named, or a file.
std::vector<fs::path> findScenarios(const std::string& name) {
    if (rubble::script::hasEnding(name, ".lua")) return {name};
    if (name != "all") return {fs::path(RUBBLE_STRESS_SCENARIOS) / (name + ".lua")};
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(RUBBLE_STRESS_SCENARIOS))
        if (entry.path().extension() == ".lua") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

/// The command that plays a run again: all that it depends on.
std::string commandOf(const Options& options, const fs::path& scenario, uint64_t seed) {
    const bool isFile = rubble::script::hasEnding(options.scenario, ".lua");
    return fmt::format("./rubble stress {} --seed {} --minutes {} --check-every {}{}",
                       shellWord(isFile ? scenario.string() : scenario.stem().string()), seed, options.minutes,
                       options.checkEvery, options.hasThreads ? " --threads" : "");
}

/// The least minutes, in few digits, that are so many steps.
double minutesOf(int steps) {
    for (double parts = 100.0;; parts *= 10.0)
        if (const double minutes = std::ceil(steps / 3600.0 * parts) / parts; stepsOf(minutes) == steps) return minutes;
}

/// What the list of its commands holds itself.
uint64_t bytesOf(const std::vector<Command>& commands) {
    static const size_t inPlace = std::string().capacity();
    uint64_t bytes = blockBytes(commands.data());
    for (const Command& command : commands) {
        if (command.text.capacity() > inPlace) bytes += blockBytes(command.text.data());
        bytes += blockBytes(command.needed.data());
    }
    return bytes;
}

/// Plays one scenario with one seed, writes its report, and prints a line. False: something did not hold.
class Job {
public:
    Job(const rubble_api& api, const Options& options, const fs::path& scenario, uint64_t seed)
        : m_api(api), m_options(options), m_command(commandOf(options, scenario, seed)) {
        m_settings.name = scenario.stem().string();
        m_settings.script = readFile(scenario);
        m_settings.seed = seed;
        if (rubble::script::hasEnding(options.scenario, ".lua"))
            m_settings.file = fs::absolute(scenario).lexically_normal().string();
        m_settings.steps = stepsOf(options.minutes);
        m_settings.checkInterval = std::max(1, int(options.checkEvery * 60.0));
        m_settings.replayEvery = options.replayEvery;
        m_settings.levels = RUBBLE_STRESS_LEVELS;
        m_settings.folder = options.out;
        m_settings.images = options.images;
        m_settings.hasThreads = options.hasThreads;
        m_settings.isInterrupted = [] { return interrupted != 0; };
    }

    bool run() {
        if (const std::string error = m_files.begin(m_settings, m_options.build); !error.empty()) {
            report(error);
            return false;
        }
        setRecordings(m_settings);
        CommandLog log;
        rubble::Progress progress(m_settings.name, m_settings.steps);
        m_settings.observer = &log;
        m_settings.heldBytes = [&] { return log.bytes(); };
        m_settings.onFailure = [&](const std::string& message) { log.close(message); };
        m_settings.onStep = [&](int step) {
            if (step % 60 == 0) progress.advance(step);
        };
        const auto start = std::chrono::steady_clock::now();
        const uint64_t heap = heapBytes();
        RunResult result = play(m_api, m_settings);
        const std::vector<Command> commands = log.take();
        result.heapLeft = int64_t(heapBytes() - bytesOf(result) - bytesOf(commands) - heap);
        if (!result.failure && result.heapLeft > kMaxHeapGrowth)
            result.failure = {"memory", fmt::format("{} KiB are left", result.heapLeft >> 10), m_settings.steps};
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        Minimised found;
        if (result.failure) found = minimiseFailure(*result.failure, commands);
        print(result, seconds);
        report(writeFigures(m_options.build, m_command, m_settings, result, seconds, found));
        if (m_options.images) report(drawGames(m_api, m_settings, result));
        return !result.failure;
    }

private:
    static void report(const std::string& error) {
        if (!error.empty()) fmt::print(stderr, "stress: {}\n", error);
    }

    /// Makes a short script, saves and prints it, or prints why there is none.
    Minimised minimiseFailure(const Failure& failure, const std::vector<Command>& commands) const {
        Minimised found;
        if (m_options.minimiseRuns > 0)
            found = minimise(m_api, m_settings, failure, commands, m_options.minimiseRuns);
        else
            found.why = "--minimise is 0";
        if (found.script.empty()) {
            fmt::print("no short script: {}\n", found.why);
            return found;
        }
        const std::string path = resultPath(m_settings, "_failure.lua");
        std::string origin = fmt::format("{}: {}. Made from {} with seed {} in {} runs.", failure.check,
                                         found.failure.message, m_settings.name, m_settings.seed, found.runs);
        std::replace_if(
            origin.begin(), origin.end(), [](char each) { return each == '\n' || each == '\r'; }, ' ');
        found.script = fmt::format("-- {}\n{}", origin, found.script);
        std::ofstream(path) << found.script;
        Options again = m_options;
        again.scenario = path;
        again.minutes = std::max(kMinMinutes, minutesOf(found.steps));
        fmt::print("{}\n{}\n", found.script, commandOf(again, path, m_settings.seed));
        return found;
    }

    void print(const RunResult& result, double seconds) const {
        uint32_t bodies = 0;
        for (const StepFigures& step : result.steps) bodies = std::max(bodies, step.bodies);
        const uint64_t removed = result.steps.empty() ? 0 : result.steps.back().removed;
        fmt::print("{:<20} seed {:<4} {:6} steps {:6} replayed {:5} bodies {:9} removed {:4} loads {:6.1f} s  {}\n",
                   m_settings.name, m_settings.seed, result.steps.size(), result.replayed, bodies, removed,
                   result.loads, seconds,
                   result.failure         ? fmt::format("FAILED at step {}: {}: {}", result.failure->step,
                                                        result.failure->check, result.failure->message)
                   : result.isInterrupted ? "interrupted; all checks held so far"
                                          : "all checks held");
        if (result.failure) fmt::print("again: {}\n", m_command);
        std::fflush(stdout);
    }

    const rubble_api& m_api;
    const Options& m_options;
    const std::string m_command;
    RunSettings m_settings;
    ResultFiles m_files;
};

int run(const Options& options) {
    catchSignals();
    const rubble_api* api = nullptr;
    if (rubble_get_api(RUBBLE_VERSION, &api) != RUBBLE_OK) return 1;
    const bool plays = !options.lists && !options.listsJobs;
    if (const std::string error = plays ? rubble::makeOutFolder(options.out) : ""; !error.empty()) {
        fmt::print(stderr, "stress: --out: {}\n", error);
        return 2;
    }
    int failed = 0;
    for (const fs::path& scenario : findScenarios(options.scenario)) {
        if (!fs::exists(scenario)) {
            fmt::print(stderr, "stress: expected a scenario that --list shows, or a file that ends in .lua, found {}\n",
                       options.scenario);
            return 2;
        }
        if (options.lists) fmt::print("{:<20} {}\n", scenario.stem().string(), descriptionOf(readFile(scenario)));
        for (const uint64_t seed : options.seeds)
            if (options.listsJobs)
                fmt::print("{} --replay-every {} --out {} --images {} --minimise {}\n",
                           commandOf(options, scenario, seed), options.replayEvery, shellWord(options.out),
                           options.images, options.minimiseRuns);
            else if (plays && !interrupted)
                failed += !Job(*api, options, scenario, seed).run();
    }
    return interrupted ? kSignalled + interrupted : failed ? 1 : 0;
}

}  // namespace
}  // namespace stress

int main(int argc, char** argv) {
    stress::Options options;
    CLI::App app{"Scenarios of destruction in Lua, with everything checked at every step", "stress"};
    app.add_option("scenario", options.scenario, "a name, all, or a file of Lua")->capture_default_str();
    std::vector<std::string> seeds = {"1"};
    app.add_option("--seed", seeds, "seeds of everything random, one run each")
        ->capture_default_str()
        ->check(CLI::Validator(stress::seedError, "UINT"));
    app.add_option("--minutes", options.minutes, "of the world, each run")
        ->capture_default_str()
        ->check(rubble::numberFrom(stress::kMinMinutes, 1e5));
    app.add_option("--check-every", options.checkEvery, "seconds of the world between checks that take long")
        ->capture_default_str()
        ->check(rubble::numberFrom(0.1, 1e5));
    app.add_option("--out", options.out, "the folder of reports")->capture_default_str();
    app.add_option("--images", options.images, "drawn of each run at most; 0: none")
        ->capture_default_str()
        ->check(CLI::Range(0, 100));
    app.add_option("--minimise", options.minimiseRuns, "runs at most to make a failing script short; 0: none is made")
        ->capture_default_str()
        ->check(CLI::Range(0, 1000000));
    app.add_flag("--list", options.lists, "the scenarios, and what they do");
    app.add_flag("--list-jobs", options.listsJobs, "a command for each run, for GNU parallel");
    app.add_option("--replay-every", options.replayEvery,
                   "the first of so many recordings is played again; 0: none, 1: all")
        ->capture_default_str()
        ->check(CLI::Range(0, 100000));
    app.add_flag("--threads", options.hasThreads, "shadows on a thread of their own, and two threads for physics");
    app.add_option("--build", options.build, "what the figures call this build")->take_last();
    CLI11_PARSE(app, argc, argv);
    options.seeds.clear();
    for (const std::string& seed : seeds)
        if (const uint64_t value = std::strtoull(seed.c_str(), nullptr, 10);
            std::find(options.seeds.begin(), options.seeds.end(), value) == options.seeds.end())
            options.seeds.push_back(value);
    return stress::run(options);
}
