// ./rubble tradeoff destruction: tables (CSV, Markdown) and plots (SVG) of what accuracy costs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "tests/tradeoff/destruction.h"

int main(int argc, char** argv) {
    using namespace rubble::tradeoff;
    Options options;
    std::string subject;
    CLI::App app{"Trade-off report: what is turned, what it costs, what it gets wrong", "tradeoff"};
    app.add_option("subject", subject, "destruction")->required()->check(CLI::IsMember({"destruction"}));
    app.add_flag("--full", options.full, "every combination: minutes instead of seconds");
    app.add_option("--out", options.out, "folder for tables and plots")->capture_default_str();
    std::string only;
    app.add_option("--only", only, "one table, as T12 or T13-load");
    app.add_option("--repeats", options.repeats, "runs of each measurement")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--seed", options.seed)->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    std::error_code ignored;
    std::filesystem::create_directories(options.out, ignored);
    const auto start = std::chrono::steady_clock::now();
    std::string report = fmt::format("# Trade-offs of destruction\n\n{}\n\n", stamp(options));
    bool written = true, holds = true;
    const std::pair<const char*, Table (*)(const Options&)> tables[] = {
        {"T4", debrisTradeoff},    {"T5", connectivityTradeoff}, {"T12", featureTradeoff},      {"T13-load", loadMap},
        {"T13-pieces", piecesMap}, {"T13-split", splitMap},      {"T13-fragments", fragmentMap}};
    for (const auto& [name, make] : tables) {
        if (!only.empty() && only != name) continue;
        const auto begin = std::chrono::steady_clock::now();
        const Table table = make(options);
        written &= writeCsv(options, table);
        holds &= !table.failed;
        report += markdown(table);
        fmt::print("{}({:.1f} s)\n\n", markdown(table), std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        std::fflush(stdout);
    }
    std::ofstream file(options.out + "/" + subject + ".md");
    file << report;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("{}\n{:.0f} s; tables and plots are in {}\n", stamp(options), seconds, options.out);
    if (!holds) fmt::print("Some tables FAILED: see their bottom lines.\n");
    return written && file.flush() && holds ? 0 : 1;
}
