// ./rubble tradeoff destruction|physics|light: tables (CSV, Markdown) and plots (SVG) of what accuracy costs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "generated/paths.h"
#include "runtime/core/log.h"
#include "tests/tradeoff/destruction.h"
#include "tests/tradeoff/light.h"
#include "tests/tradeoff/physics.h"

namespace rubble::tradeoff {
namespace {

using Row = std::pair<std::string, std::function<Table(const Options&)>>;

std::vector<Row> rowsOf(const std::string& subject) {
    if (subject == "destruction")
        return {{"T4", debrisTradeoff},        {"T5", connectivityTradeoff}, {"T12", featureTradeoff},
                {"T13-stress", stressMap},     {"T13-pieces", piecesMap},    {"T13-split", splitMap},
                {"T13-fragments", fragmentMap}};
    if (subject == "light")
        return {{"T6", shadowCellTradeoff},
                {"T7", walkTradeoff},
                {"T8", rayTradeoff},
                {"T9", denoiserTradeoff},
                {"T10-gbuffer", gbufferTradeoff},
                {"T12-light", lightFeatureTradeoff},
                {"T12-light-rules", lightRuleTradeoff},
                {"T13-sphere-light", sphereLightMap},
                {"T13-visibility", visibilityMap},
                {"T13-penumbra", penumbraMap}};
    std::vector<Row> rows{{"T1", contactTradeoff},
                          {"T1-penetration", penetrationTradeoff},
                          {"T2", rotationTradeoff},
                          {"T3", collisionTradeoff},
                          {"T10-coordinates", coordinateTradeoff},
                          {"T12-physics", physicsFeatureTradeoff},
                          {"T12-unused", unusedFeatureTradeoff}};
    for (Row& map : physicsMaps()) rows.push_back(std::move(map));
    return rows;
}

/// Makes a table, prints it and writes its files.
Table makeTable(const Row& row, const Options& options, bool& written) {
    const auto begin = std::chrono::steady_clock::now();
    Table table = row.second(options);
    table.stamp = stamp(options);
    written &= writeCsv(options, table);
    fmt::print("{}({:.1f} s)\n\n", markdown(table),
               std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    std::fflush(stdout);
    return table;
}

/// The document with the subject's part replaced: physics comes first, then light, then what ./rubble stress writes.
/// isAll: by these tables alone; else tables that were not measured stay as they are.
std::string envelopeWith(const std::string& subject, const std::string& path, const std::vector<Table>& maps,
                         bool isAll) {
    std::ifstream file(path);
    const std::string before{std::istreambuf_iterator<char>(file), {}};
    const auto from = [&](const char* title) { return std::min(before.find(title), before.size()); };
    const size_t stress = from("\n# Stress scenarios\n"), light = std::min(from("\n# The light\n"), stress);
    const auto kept = [&](const std::string& part) { return isAll ? std::string() : part; };
    if (subject == "light")
        return before.substr(0, light) + lightEnvelope(maps, kept(before.substr(light, stress - light))) +
               before.substr(stress);
    return operatingEnvelope(maps, kept(before.substr(0, light))) + before.substr(light);
}

bool writeText(const std::string& path, const std::string& text) {
    std::ofstream file(path);
    file << text;
    return bool(file.flush());
}

}  // namespace
}  // namespace rubble::tradeoff

int main(int argc, char** argv) {
    using namespace rubble::tradeoff;
    Options options;
    std::string subject, only, scene;
    bool publish = false;
    CLI::App app{"Measures what accuracy costs and where the engine's limits are", "tradeoff"};
    app.add_option("subject", subject, "destruction, physics or light")
        ->required()
        ->check(CLI::IsMember({"destruction", "physics", "light"}));
    app.add_flag("--full", options.full, "every combination: minutes instead of seconds");
    app.add_option("--out", options.out, "folder for tables and plots")->capture_default_str();
    app.add_option("--only", only, "only the table of this name, or those whose names begin with it, such as T12");
    app.add_option("--repeats", options.repeats, "runs of each measurement")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000000));
    app.add_option("--seed", options.seed, "seed of everything random")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    app.add_flag("--publish", publish,
                 "physics or light: write its part of OPERATING_ENVELOPE.md; with --only these tables");
    app.add_option("--feature-scene", scene)->group("");  // for this program under valgrind
    CLI11_PARSE(app, argc, argv);
    rubble::setLogSink([](void*, rubble::LogLevel, std::string_view) {},
                       nullptr);  // the extreme settings log many warnings
    if (!scene.empty()) return runFeatureScene(scene) ? 0 : 1;

    std::error_code ignored;
    std::filesystem::create_directories(options.out, ignored);
    const auto start = std::chrono::steady_clock::now();
    std::string report = fmt::format("# Trade-offs of {}\n\n{}\n\n", subject, stamp(options));
    bool written = true, holds = true;
    std::vector<Table> maps;
    const std::vector<Row> rows = rowsOf(subject);
    if (std::none_of(rows.begin(), rows.end(), [&](const Row& row) { return row.first.rfind(only, 0) == 0; })) {
        fmt::print(stderr, "--only: expected the beginning of one of these names, found \"{}\":", only);
        for (const Row& row : rows) fmt::print(stderr, " {}", row.first);
        fmt::print(stderr, "\n");
        return 1;
    }
    const bool isName = std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.first == only; });
    for (const auto& row : rows) {
        if (isName ? row.first != only : row.first.rfind(only, 0) != 0) continue;
        const Table table = makeTable(row, options, written);
        report += markdown(table);
        holds &= !table.failed;
        if (!table.envelope.empty() || subject == "light") maps.push_back(table);
    }
    written &= writeText(options.out + "/" + subject + ".md", report);
    if (publish) {
        const std::string path = RUBBLE_SOURCE_DIR "/OPERATING_ENVELOPE.md";
        written &= writeText(path, envelopeWith(subject, path, maps, only.empty()));
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("{}\n{:.0f} s; tables and plots are in {}\n", stamp(options), seconds, options.out);
    if (!holds) fmt::print("Some tables FAILED: their conclusions say why.\n");
    return written && holds ? 0 : 1;
}
