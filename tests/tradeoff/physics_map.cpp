#include "tests/tradeoff/physics_map.h"

#include <fmt/format.h>

#include <algorithm>

#include "tests/tradeoff/physics.h"

namespace rubble::tradeoff {

Judged judge(double value, double stable, double degraded, const std::string& text) {
    return {value <= stable ? Outcome::Stable : value <= degraded ? Outcome::Degraded : Outcome::Failed, text};
}

std::vector<std::string> presetNames() {
    std::vector<std::string> names;
    for (const Preset& preset : presets()) names.push_back(preset.name);
    return names;
}

std::vector<std::string> namesOf(const std::vector<double>& values, const char* unit) {
    std::vector<std::string> names;
    for (const double value : values) names.push_back(fmt::format("{:g}{}", value, unit));
    return names;
}

namespace {

/// The stable range of a row.
StableRange rangeOf(const Map& map, size_t row, const std::vector<double>& xs, const std::vector<Judged>& line) {
    const auto value = [&](size_t i) { return fmt::format("{:g} {}", xs[i], map.xUnit); };
    const bool rises = xs.front() < xs.back();
    const std::string upTo = rises ? "stable up to " : "stable down to ",
                      last = rises ? ", the largest value tried" : ", the smallest value tried";
    size_t stable = 0;
    while (stable < line.size() && line[stable].outcome == Outcome::Stable) ++stable;
    if (stable == line.size()) return {map.rows[row], upTo + value(stable - 1) + last};
    const auto failed =
        std::find_if(line.begin(), line.end(), [](const Judged& each) { return each.outcome == Outcome::Failed; });
    const std::string fails = failed == line.end() ? "" : value(size_t(failed - line.begin()));
    return {map.rows[row],
            (stable ? upTo + value(stable - 1) : "nowhere stable from " + value(0) + " on") +
                (fails.empty() ? ", nowhere fails" : ", fails at " + fails),
            fails};
}

}  // namespace

Table drawMap(const Options& options, const Map& map) {
    Table table{map.name, map.title, {map.yLabel, map.xLabel, "outcome", "figure"}, {}};
    table.note = std::string("Stable: ") + map.criterion + ".";
    std::vector<double> xs = map.pushed;
    if (options.full) xs.insert(xs.end(), map.pushedFull.begin(), map.pushedFull.end());
    std::vector<MapCell> cells;
    std::string words;
    for (size_t row = 0; row < map.rows.size(); ++row) {
        std::vector<Judged> line;
        for (const double x : xs) {
            const Judged& seen = line.emplace_back(map.evaluate(x, row, options.full));
            std::string flat = seen.text;
            std::replace(flat.begin(), flat.end(), '\n', ' ');
            table.add({map.rows[row], fmt::format("{:g}", x), nameOf(seen.outcome), flat});
            cells.push_back({fmt::format("{:g}", x), map.rows[row], seen.outcome, seen.text});
        }
        table.envelope.push_back(rangeOf(map, row, xs, line));
        words += fmt::format("{}{}: {}", row ? "; " : "", map.rows[row], table.envelope.back().holds);
    }
    table.conclusion = words + ".";
    writeMap(options, map.name, fmt::format("{}: {}", map.name, map.title), map.xLabel, map.yLabel, cells,
             {"stable", "degraded", "failed", nullptr});
    return table;
}

}  // namespace rubble::tradeoff
