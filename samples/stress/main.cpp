// Random demolition at speed, round after round of a level, with everything that must always hold checked at every
// step:
// ./rubble stress. A bar while it runs, a table at the end.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <optional>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "samples/stress/round.h"
#include "samples/support/progress.h"

namespace rubble {
namespace {

constexpr double kMiB = 1024.0 * 1024.0;
/// What an emptied loop may hold on to more than after half of the rounds: lists grow to the most that they ever held.
constexpr double kMaxHeapGrowth = 64.0 * 1024.0;

/// Joules that may come from nothing in all rounds, as a share of what contacts and friction take.
constexpr double kMaxGainShare = 1e-3;

void printHeader() {
    fmt::print(
        "| round | edits | pieces | removed  | bodies | mean ms |   p50  |  p99   | worst | quiet | lost kJ  | gained "
        "J | most MiB | emptied KiB | "
        "resident | hash             |\n");
}

void printRound(int number, const RoundResult& r, size_t emptied) {
    fmt::print(
        "| {:5} | {:5} | {:6} | {:8} | {:6} | {:7.2f} | {:6.2f} | {:6.2f} | {:5.0f} | {:5} | {:8.0f} | {:8.1f} | "
        "{:8.1f} | {:11.1f} | {:8.1f} | "
        "{:016x} |\n",
        number, r.edits, r.pieces, r.removed, r.maxBodies, r.meanMs, r.medianMs, r.p99Ms, r.worstMs, r.comparedSteps,
        r.lost / 1e3, r.gained, double(r.maxHeapBytes) / kMiB, double(emptied) / 1024.0, double(residentBytes()) / kMiB,
        r.hashes.empty() ? 0 : r.hashes.back());
    std::fflush(stdout);
}

/// What clings to one running loop after each round: no more after all of them than after half. "" if so.
std::string compareMemory(const std::vector<size_t>& emptied) {
    if (emptied.size() < 4) return {};
    const double half = double(emptied[emptied.size() / 2 - 1]), all = double(emptied.back());
    if (all <= half + kMaxHeapGrowth) return {};
    return fmt::format("what an emptied world holds on to grew from {:.1f} to {:.1f} KiB", half / 1024.0, all / 1024.0);
}

/// The round from its save, in a loop of its own with two threads: what is different, or "".
std::string playAgain(const Round& round, SavedGame beginning, const RoundResult& first,
                      const std::function<void()>& onStep) {
    FrameLoop loop(stressLoop(2));
    loop.load(std::move(beginning));
    const RoundResult result = playRound(round, loop, onStep);
    if (!result.error.empty()) return result.error;
    return result.hashes == first.hashes ? "" : "loaded and played again with two threads it comes to other hashes";
}

int run(int argc, char** argv) {
    Round round;
    int steps = 1200, again = 4;
    std::string file;
    CLI::App app{"Random demolition with every invariant checked at every step", "stress"};
    app.add_option("--seed", round.seed)->capture_default_str();
    app.add_option("--steps", steps, "of 1/60 s, in all; 108000 are half an hour")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--round", round.steps, "steps after which the level is loaded anew")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--edits-every", round.editInterval, "steps between edits")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--repeat-every", again,
                   "every so many rounds one is played again, with two threads, and must come to the same; 0: none")
        ->capture_default_str();
    app.add_option("--level", file, ".vdb, .vox or .rubble; the town if not given");
    CLI11_PARSE(app, argc, argv);

    Level level;
    if (!file.empty()) {
        const auto tool =
            std::filesystem::weakly_canonical(std::filesystem::path(argv[0])).parent_path() / "rubble-vdb";
        Result<Level> read = readLevel(file, tool.string());
        if (!read) return logError(read.error()), 1;
        level = std::move(*read);
        round.level = &level;
    }
    const int rounds = (steps + round.steps - 1) / round.steps;
    round.recordedSteps = std::min(round.recordedSteps, round.steps / 4);
    const int repeated = again ? (rounds + again - 1) / again : 0;
    Progress progress("demolition", (rounds + repeated) * round.steps);
    int done = 0;
    const auto onStep = [&] {
        if (++done % 60 == 0) progress.advance(done);
    };
    std::vector<size_t> emptied;
    emptied.reserve(size_t(rounds));
    std::string error;
    size_t all = 0;
    double lost = 0.0, gained = 0.0;
    const auto start = std::chrono::steady_clock::now();
    printHeader();
    FrameLoop loop(stressLoop(1));  // one for all rounds, as a game's
    for (int i = 0; i < rounds && error.empty(); ++i) {
        round.number = i;
        loadRound(round, loop);
        const bool isRepeated = again && i % again == 0;
        std::optional<SavedGame> beginning;
        if (isRepeated) beginning = loop.save();
        const RoundResult result = playRound(round, loop, onStep);
        error = result.error;
        all += size_t(round.steps), lost += result.lost, gained += result.gained;
        if (isRepeated && error.empty()) error = playAgain(round, std::move(*beginning), result, onStep);
        beginning.reset();
        emptied.push_back(heapBytesWhenEmptied(loop));
        printRound(i, result, emptied.back());
    }
    if (error.empty()) error = compareMemory(emptied);
    if (error.empty() && gained > kMaxGainShare * lost)
        error = "more than a thousandth of the energy lost came from nothing";
    fmt::print(
        "stress: {} steps in {} rounds, {} of them isRepeated, seed {}, {:.0f} s; {:.0f} kJ lost, {:.1f} kJ from "
        "nothing: {}\n",
        all, emptied.size(), repeated, round.seed,
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), lost / 1e3, gained / 1e3,
        error.empty() ? "all held" : "FAILED in round " + std::to_string(round.number) + ": " + error);
    return error.empty() ? 0 : 1;
}

}  // namespace
}  // namespace rubble

int main(int argc, char** argv) {
    return rubble::run(argc, argv);
}
