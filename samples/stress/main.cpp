// Random demolition at speed, round after round of a level, with everything that must always hold checked at every step:
// ./rubble stress. A bar while it runs, a table at the end.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "samples/stress/round.h"
#include "samples/support/progress.h"

namespace rubble {
namespace {

constexpr double kMiB = 1024.0 * 1024.0;
constexpr double kGrowthAllowed = 1.0;  ///< MiB of live memory after a round, over that after the second: the figures themselves

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    const size_t at = std::min(values.size() - 1, size_t(share * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(at), values.end());
    return values[at];
}

void printRound(int number, const RoundResult& r) {
    const MechanicalEnergy& e = r.energy;
    fmt::print("| {:5} | {:6} | {:5} | {:6} | {:8} | {:6} | {:6.2f} | {:6.2f} | {:7.1f} | {:6} | {:9.0f} | {:8.2f} | {:7.1f} | {:8.1f} | {:016x} |\n",
               number, r.stepMs.size(), r.edits, r.pieces, r.removed, r.mostBodies, quantile(r.stepMs, 0.5), quantile(r.stepMs, 0.99),
               *std::max_element(r.stepMs.begin(), r.stepMs.end()), e.stepsCompared(), e.lost() / 1e3, e.gained() / 1e3, double(r.liveBytes) / kMiB,
               double(r.residentBytes) / kMiB, r.hashes.empty() ? 0 : r.hashes.back());
    std::fflush(stdout);
}

/// What does not hold over all rounds; "" if all does.
std::string compareMemory(const std::vector<RoundResult>& rounds) {
    if (rounds.size() < 3) return {};
    const double before = double(rounds[1].liveBytes), after = double(rounds.back().liveBytes);
    if (after <= before + kGrowthAllowed * kMiB) return {};
    return fmt::format("live memory grew from {:.1f} to {:.1f} MiB", before / kMiB, after / kMiB);
}

int run(int argc, char** argv) {
    Round round;
    int steps = 1200, again = 4;
    std::string file;
    CLI::App app{"Random demolition with every invariant checked at every step", "stress"};
    app.add_option("--seed", round.seed)->capture_default_str();
    app.add_option("--steps", steps, "of 1/60 s, in all; 108000 are half an hour")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--round", round.steps, "steps after which the level is loaded anew")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--edits-every", round.editsEvery, "steps between edits")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--again", again, "every so many rounds one is played again, with two threads, and must come to the same; 0: none")
        ->capture_default_str();
    app.add_option("--level", file, ".vdb, .vox or .rubble; the town if not given");
    CLI11_PARSE(app, argc, argv);

    Level level;
    if (!file.empty()) {
        const auto tool = std::filesystem::weakly_canonical(std::filesystem::path(argv[0])).parent_path() / "rubble-vdb";
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
    const auto advanced = [&] {
        if (++done % 60 == 0) progress.advance(done);
    };
    std::vector<RoundResult> results;
    std::string wrong;
    fmt::print(
        "| round |  steps | edits | pieces | removed  | bodies |   p50  |  p99   | worst ms| quiet  | lost kJ   | gained kJ| live MiB| resident | "
        "hash             |\n");
    for (int i = 0; i < rounds && wrong.empty(); ++i) {
        round.number = i;
        round.threads = 1;
        results.push_back(playRound(round, advanced));
        printRound(i, results.back());
        wrong = results.back().wrong;
        if (!again || i % again || !wrong.empty()) continue;
        round.threads = 2;
        const RoundResult other = playRound(round, advanced);
        wrong = other.wrong;
        if (wrong.empty() && other.hashes != results.back().hashes) wrong = "played again with two threads it comes to other hashes";
    }
    if (wrong.empty()) wrong = compareMemory(results);
    size_t all = 0;
    for (const RoundResult& result : results) all += result.stepMs.size();
    fmt::print("stress: {} steps in {} rounds, {} of them twice, seed {}: {}\n", all, results.size(), repeated, round.seed,
               wrong.empty() ? "all held" : "FAILED in round " + std::to_string(round.number) + ": " + wrong);
    return wrong.empty() ? 0 : 1;
}

}  // namespace
}  // namespace rubble

int main(int argc, char** argv) {
    return rubble::run(argc, argv);
}
