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
    app.add_flag("--full", options.full, "every combination and five runs each: minutes instead of seconds");
    app.add_option("--out", options.out, "folder for tables and plots")->capture_default_str();
    app.add_option("--seed", options.seed)->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    std::error_code ignored;
    std::filesystem::create_directories(options.out, ignored);
    const auto start = std::chrono::steady_clock::now();
    std::string report = fmt::format("# Trade-offs of destruction\n\n{}\n\n", stamp(options));
    bool written = true;
    for (const auto make : {debrisTradeoff, connectivityTradeoff, featureTradeoff, piecesMap, brushMap, beamMap}) {
        const Table table = make(options);
        written &= writeCsv(options, table);
        report += markdown(table);
        fmt::print("{}", markdown(table));
        std::fflush(stdout);
    }
    std::ofstream file(options.out + "/" + subject + ".md");
    file << report;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("{}\n{:.0f} s; tables and plots are in {}\n", stamp(options), seconds, options.out);
    return written && file.flush() ? 0 : 1;
}
