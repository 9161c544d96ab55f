// ./rubble stress demolition: random demolition, round after round of a level, with every invariant checked at every
// step. Prints a table with a line per round.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <optional>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "samples/stress/demolition/round.h"
#include "samples/support/progress.h"

namespace rubble {
namespace {

constexpr double kMiB = 1024.0 * 1024.0;
/// Bytes by which the heap of an emptied loop may grow from half of the rounds to all of them: lists keep the largest
/// capacity that they ever had.
constexpr double kMaxHeapGrowth = 64.0 * 1024.0;
/// Joules gained in all rounds, as a share of the joules lost to contacts and friction. No physical effect gains
/// energy.
constexpr double kMaxGainShare = 1e-3;

void printHeader() {
    fmt::print(
        "| round | edits | pieces | removed  | bodies | mean ms |   p50  |  p99   | worst | quiet | lost kJ  | gained "
        "J |  max MiB | emptied KiB | resident | hash             |\n");
}

void printRound(int number, const RoundResult& r, size_t emptied) {
    fmt::print(
        "| {:5} | {:5} | {:6} | {:8} | {:6} | {:7.2f} | {:6.2f} | {:6.2f} | {:5.0f} | {:5} | {:8.0f} | {:8.1f} | "
        "{:8.1f} | {:11.1f} | {:8.1f} | {:016x} |\n",
        number, r.edits, r.pieces, r.removed, r.maxBodies, r.meanMs, r.medianMs, r.p99Ms, r.worstMs, r.comparedSteps,
        r.lost / 1e3, r.gained, double(r.maxHeapBytes) / kMiB, double(emptied) / 1024.0, double(residentBytes()) / kMiB,
        r.hashes.empty() ? 0 : r.hashes.back());
    std::fflush(stdout);
}

/// Finds a leak: "" unless the heap of the emptied loop grew in the second half of the rounds.
std::string compareMemory(const std::vector<size_t>& emptied) {
    if (emptied.size() < 4) return {};
    const double half = double(emptied[emptied.size() / 2 - 1]), all = double(emptied.back());
    if (all <= half + kMaxHeapGrowth) return {};
    return fmt::format("the heap of an emptied world grew from {:.1f} to {:.1f} KiB in the second half of the rounds",
                       half / 1024.0, all / 1024.0);
}

/// Plays a round from its save in a new loop with two threads; "" if it gives the same hashes.
std::string playAgain(const Round& round, SavedGame beginning, const RoundResult& first,
                      const std::function<void()>& onStep) {
    FrameLoop loop(stressLoop(2));
    loop.load(std::move(beginning));
    const RoundResult result = playRound(round, loop, onStep);
    if (!result.error.empty()) return result.error;
    return result.hashes == first.hashes ? "" : "loaded and played with two threads, the round gives other hashes";
}

struct StressOptions {
    Round round;
    int steps = 1200;     ///< of 1/60 s, in all
    int repeatEvery = 4;  ///< rounds; 0: none is played again
    std::string level;    ///< a file; "": the stress level
};

/// All rounds in one frame loop, as a game would play them one after the other.
class StressRun {
public:
    explicit StressRun(const StressOptions& options)
        : m_round(options.round),
          m_rounds((options.steps + m_round.steps - 1) / m_round.steps),
          m_repeatEvery(options.repeatEvery),
          m_repeated(m_repeatEvery ? (m_rounds + m_repeatEvery - 1) / m_repeatEvery : 0),
          m_progress("demolition", (m_rounds + m_repeated) * m_round.steps) {
        m_round.recordedSteps = std::min(m_round.recordedSteps, m_round.steps / 4);
        m_emptied.reserve(size_t(m_rounds));
    }

    /// Plays the rounds until one fails, and prints a line for each and a summary. Returns the exit code.
    int run() {
        const auto start = std::chrono::steady_clock::now();
        printHeader();
        for (int i = 0; i < m_rounds && m_error.empty(); ++i) playOne(i);
        if (m_error.empty()) m_error = compareMemory(m_emptied);
        if (m_error.empty() && m_gained > kMaxGainShare * m_lost)
            m_error =
                fmt::format("expected at most {} J gained for each J lost, found {}", kMaxGainShare, m_gained / m_lost);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        fmt::print(
            "stress: {} steps in {} rounds, {} of them twice, seed {}, {:.0f} s; {:.0f} kJ lost, {:.1f} kJ gained: "
            "{}\n",
            m_emptied.size() * size_t(m_round.steps), m_emptied.size(), m_repeated, m_round.seed, seconds, m_lost / 1e3,
            m_gained / 1e3,
            m_error.empty() ? "all invariants held"
                            : "FAILED in round " + std::to_string(m_round.number) + ": " + m_error);
        return m_error.empty() ? 0 : 1;
    }

private:
    void playOne(int number) {
        m_round.number = number;
        loadRound(m_round, m_loop);
        const auto onStep = [this] {
            if (++m_done % 60 == 0) m_progress.advance(m_done);
        };
        const bool isRepeated = m_repeatEvery && number % m_repeatEvery == 0;
        std::optional<SavedGame> beginning;
        if (isRepeated) beginning = m_loop.save();
        const RoundResult result = playRound(m_round, m_loop, onStep);
        m_error = result.error;
        m_lost += result.lost, m_gained += result.gained;
        if (isRepeated && m_error.empty()) m_error = playAgain(m_round, std::move(*beginning), result, onStep);
        beginning.reset();
        m_emptied.push_back(heapBytesWhenEmptied(m_loop));
        printRound(number, result, m_emptied.back());
    }

    Round m_round;
    const int m_rounds, m_repeatEvery, m_repeated;
    Progress m_progress;
    FrameLoop m_loop{stressLoop(1)};
    int m_done = 0;                 ///< steps, of all rounds
    std::vector<size_t> m_emptied;  ///< heap bytes after each round
    double m_lost = 0.0, m_gained = 0.0;
    std::string m_error;
};

int run(int argc, char** argv) {
    StressOptions options;
    CLI::App app{"Random demolition with every invariant checked at every step", "stress demolition"};
    app.add_option("--seed", options.round.seed, "seed of everything random")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    app.add_option("--steps", options.steps, "steps of 1/60 s in all; 108000 are half an hour")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000000));
    app.add_option("--round", options.round.steps, "steps per round; each round loads the level again")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000000));
    app.add_option("--edits-every", options.round.editInterval, "steps between edits")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000000));
    app.add_option("--repeat-every", options.repeatEvery,
                   "play one of this many rounds again, with two threads; it must give the same hashes; 0: none")
        ->capture_default_str();
    app.add_option("--level", options.level, "a .vdb, .vox or .rubble file instead of the town");
    CLI11_PARSE(app, argc, argv);

    Level level;
    if (!options.level.empty()) {
        const auto tool =
            std::filesystem::weakly_canonical(std::filesystem::path(argv[0])).parent_path() / "rubble-vdb";
        Result<Level> read = readLevel(options.level, tool.string());
        if (!read) return logError(read.error()), 1;
        level = std::move(*read);
        options.round.level = &level;
    }
    return StressRun(options).run();
}

}  // namespace
}  // namespace rubble

int main(int argc, char** argv) {
    return rubble::run(argc, argv);
}
